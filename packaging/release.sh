#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Makes everything that a person downloads, in FOLDER: packages of Debian's and an archive for Linux, archives for Linux on 64-bit ARM
# and for Windows, the npm package, the page, a list of what is linked in, the notes, and checksums. The same commit gives the same bytes.
#   packaging/release.sh FOLDER [PART...]     PART: linux, arm64, windows, web; otherwise all. The checksums are of what FOLDER has
# CLIPC_BUILD=FOLDER names a build for Linux that exists; otherwise cmake/build_profiled.sh makes one. What is not built is built: hours
# on a small machine, where nothing is.
set -euo pipefail
cd "$(dirname "$0")/.."
. cmake/setup.sh
usage() {
  sed -n '3,7s/^# //p' "$0" >&2
  exit 2
}
[ $# -ge 1 ] || usage
mkdir -p "$1"
out=$(realpath "$1")
shift
[ $# -gt 0 ] || set -- linux arm64 windows web
version=$(sed -n 's/^project(clipc VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# pack BUILD_FOLDER GENERATOR...: what CPack makes of a build.
pack() {
  local build=$1 generator
  shift
  for generator in "$@"; do
    (cd "$build" && quietly cpack -G "$generator" -B "$scratch/packed")
  done
  find "$scratch/packed" -maxdepth 1 -type f -exec mv {} "$out" \;
}

make_linux() {
  local build=${CLIPC_BUILD:-build/profiled}
  [ -n "${CLIPC_BUILD:-}" ] || cmake/build_profiled.sh
  install_packages dpkg-dev file
  pack "$build" TGZ DEB
  packaging/describe_release.py "$out" "$version"
}

make_arm64() {
  install_packages "${arm64_packages[@]}"
  cmake/arm64/fetch_libraries.sh
  configure_preset arm64 OFF && build_preset arm64
  cmake/arm64/try_program.sh build/arm64/bin/clipc
  pack build/arm64 TGZ
}

make_windows() {
  install_packages "${windows_packages[@]}"
  cmake/cross/fetch_sources.sh
  configure_preset windows OFF && build_preset windows
  pack build/windows ZIP
}

make_web() {
  install_packages zip
  web/build.sh page
  cp "build/web/clipc-$version.tgz" "$out/clipc-$version-npm.tgz"
  # Names in order, and the commit's time: zip writes what it is given.
  find build/page -exec touch --no-dereference --date="@$SOURCE_DATE_EPOCH" {} +
  rm -f "$out/clipc-$version-page.zip"
  (cd build/page && find . -type f | LC_ALL=C sort | TZ=UTC zip -X -9 -q "$out/clipc-$version-page.zip" -@)
}

for part in "$@"; do
  case $part in
    linux | arm64 | windows | web) "make_$part" ;;
    *) usage ;;
  esac
done
(cd "$out" && find . -maxdepth 1 -type f ! -name SHA256SUMS -printf '%P\n' | LC_ALL=C sort | xargs sha256sum -- >"$scratch/sums")
mv "$scratch/sums" "$out/SHA256SUMS"
ls -l "$out"
