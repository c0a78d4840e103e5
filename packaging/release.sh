#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Makes everything that a person downloads, in FOLDER: packages of Debian's and an archive for Linux, an archive for Windows, the npm
# package, the page, a list of what is linked in, the notes, and checksums. The same commit gives the same bytes.
#   packaging/release.sh FOLDER [BUILD_FOLDER]     BUILD_FOLDER: a build for Linux that exists; otherwise cmake/build_profiled.sh makes one
# What is not built is built: hours on a small machine, where nothing is.
set -euo pipefail
cd "$(dirname "$0")/.."
. cmake/setup.sh
[ $# -ge 1 ] || { sed -n '3,6s/^# //p' "$0" >&2; exit 2; }
mkdir -p "$1"
out=$(realpath "$1")
version=$(sed -n 's/^project(clipc VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH

linux=${2:-}
if [ -z "$linux" ]; then
  cmake/build_profiled.sh
  linux=build/profiled
fi
install_packages dpkg-dev zip
packed=$(mktemp -d)
trap 'rm -rf "$packed"' EXIT
for generator in TGZ DEB; do
  (cd "$linux" && quietly cpack -G "$generator" -B "$packed")
done

install_packages "${windows_packages[@]}"
cmake/cross/fetch_sources.sh
configure_preset windows OFF && build_preset windows
(cd build/windows && quietly cpack -G ZIP -B "$packed")
mv "$packed"/*.{tar.gz,deb,zip} "$out"

web/build.sh page
cp build/web/clipc-*.tgz "$out/clipc-$version-npm.tgz"
# Names in order, and the commit's time: zip writes what it is given.
find build/page -exec touch --no-dereference --date="@$SOURCE_DATE_EPOCH" {} +
rm -f "$out/clipc-$version-page.zip"
(cd build/page && find . -type f | LC_ALL=C sort | TZ=UTC zip -X -9 -q "$out/clipc-$version-page.zip" -@)

packaging/describe_release.py "$out" "$version"
(cd "$out" && sha256sum -- *.tar.gz *.deb *.zip *.tgz *.json *.md >SHA256SUMS)
ls -l "$out"
