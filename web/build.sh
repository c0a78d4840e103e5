#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Builds what runs in a browser and in node.
#   web/build.sh package      build/web/clipc-VERSION.tgz, with the module that build/wasm makes
#   web/build.sh page         and the page, in build/page
set -euo pipefail
cd "$(dirname "$0")/.."
. cmake/setup.sh

node=$(node --version 2>/dev/null | sed 's/^v\([0-9]*\).*/\1/')
if [ "${node:-0}" -lt 20 ] || ! command -v npm >/dev/null; then
  echo "web/build.sh: node 20 or newer and npm are needed" >&2
  exit 1
fi
install_packages "${build_packages[@]}" "${web_packages[@]}"
cmake/cross/fetch_sources.sh
mkdir -p build/web
touch build/web/starts # what is written from here on is newer than what is made
[ -f build/wasm/build.ninja ] || quietly cmake --preset wasm
build_preset wasm --target clipc_module clipc_light -- --quiet >&2

package=build/web/package
mkdir -p "$package"
cp web/npm/* LICENSE build/wasm/bin/clipc.wasm "$package"
(cd "$package" && quietly npm pack --pack-destination ..)
[ "${1:-package}" = page ] || exit 0

mkdir -p build/web/page/{gallery,tables}
cp web/page/* build/wasm/bin/light.wasm build/web/page
mkdir -p build/page
cp web/page/{index.html,style.css} build/page
cp examples/gallery/*.{hlsl,fx} build/web/page/gallery
cp study/tables/speed.csv build/web/page/tables

# The examples, installed as a reader does it, and with this package. Their paths are for folders as deep as theirs.
for example in vite webpack; do
  mkdir -p "build/examples/$example"
  cp -r "web/examples/$example/." "build/examples/$example"
  (
    cd "build/examples/$example"
    [ -d node_modules/clipc ] || quietly npm install --no-audit --no-fund
    cp ../../web/package/* node_modules/clipc
  )
done

install_node_packages
cd build/web/page
quietly npm run build
rm -rf ../../page/docs
node documents.js ../../../docs ../../page/docs
node compress.js ../../page
mv ../starts ../made
