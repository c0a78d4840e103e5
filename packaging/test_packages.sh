#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Makes the packages of a release build, of which the target `study` was built too, has lintian read them, installs them in a clean
# root and builds examples/first there: what somebody does who uses clipc for the first time. Then the same with the .tar.gz, and
# with what `dpkg --remove` leaves.
#   packaging/test_packages.sh BUILD_FOLDER      as root, with debootstrap, lintian, man-db and bash-completion installed
# CLIPC_CLEAN_ROOT=FOLDER names what debootstrap made before, with the packages below.
set -euo pipefail
cd "$(dirname "$0")/.."
build=$(realpath "$1")
scratch=$(mktemp -d)
root=$scratch/root
trap 'umount -q "$root/proc" 2>/dev/null || true; rm -rf --one-file-system "$scratch"' EXIT

fail() {
  echo "test_packages: $*" >&2
  exit 1
}
inside() { chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 "$@"; }

echo "-- packages, twice the same bytes"
SOURCE_DATE_EPOCH=$(date +%s)
export SOURCE_DATE_EPOCH
for folder in "$scratch" "$scratch/again"; do
  (cd "$build" && cpack -G DEB -B "$folder" && cpack -G TGZ -B "$folder") >"$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }
done
for package in "$scratch"/*.deb "$scratch"/*.tar.gz; do
  cmp "$package" "$scratch/again/${package##*/}" || fail "${package##*/} has other bytes the second time"
done
rm -rf "$scratch/again"
debs=("$scratch"/{clipc,libclipc1,libclipc-dev,clipc-study}_*.deb)
[ -f "${debs[3]}" ] || fail "expected four packages, got ${debs[*]}"

echo "-- lintian"
lintian --allow-root --fail-on error,warning "${debs[@]}"

echo "-- licences of what is linked in"
dpkg-deb -x "$scratch"/clipc_*.deb "$scratch/program"
for name in libclang llvm glslang spirv-tools libfmt nlohmann-json3 libstdc++ libc6; do
  compgen -G "$scratch/program/usr/share/doc/clipc/linked/$name*" >/dev/null || fail "no licence of $name"
done

packaging/describe_release.py "$scratch" "$(dpkg-deb --field "${debs[0]}" Version)"
for name in "$scratch"/program/usr/share/doc/clipc/linked/*; do
  grep -q "pkg:deb/debian/${name##*/}@" "$scratch"/clipc-*.spdx.json || fail "the list of what is linked lacks ${name##*/}"
done

echo "-- what a start and a shader cost"
kind=release
! grep -q '^CLIPC_PROFILE:[A-Z]*=use$' "$build/CMakeCache.txt" || kind=profiled
tools/checks/check_instructions.py "$scratch/program/usr/bin/clipc" "$kind" || [ $? -eq 77 ]

echo "-- links of the pages"
tools/checks/check_pages.py "$scratch/program/usr/share/doc/clipc"

echo "-- manual page and completion"
dpkg-deb -x "$scratch"/clipc-study_*.deb "$scratch/study"
for page in "$scratch"/{program,study}/usr/share/man/man1/*.gz; do
  warnings=$(MANWIDTH=80 LC_ALL=C.UTF-8 man --warnings -E UTF-8 -l "$page" 2>&1 >/dev/null)
  [ -z "$warnings" ] || fail "${page##*/}: $warnings"
done
PATH=$scratch/program/usr/bin:$PATH bash packaging/test_completion.sh "$scratch/program/usr/share/bash-completion/completions/clipc"

echo "-- a clean root"
needed=$(dpkg-deb --field "${debs[3]}" Depends | sed 's/ ([^)]*)//g; s/, /,/g') # of Debian's alone
if [ -n "${CLIPC_CLEAN_ROOT:-}" ]; then
  cp -a "$CLIPC_CLEAN_ROOT" "$root"
else
  debootstrap --variant=minbase --include=g++,cmake,make,pkg-config,libegl-dev,libgl-dev,libopengl-dev,libegl1,libgl1-mesa-dri,"$needed" \
    "$(. /etc/os-release && echo "$VERSION_CODENAME")" "$root" >"$scratch/log" 2>&1 || { tail -n 40 "$scratch/log"; exit 1; }
fi
[ ! -L "$root/proc" ] || { rm "$root/proc" && mkdir "$root/proc"; } # debootstrap makes a link in a container
mount -t proc proc "$root/proc"
mkdir "$root/debs" && cp "${debs[@]}" "$scratch"/clipc-*.tar.gz "$root/debs"
cp -r examples/first cmake/outside_c_project study/scenes/harbour.json "$root/root"

echo "-- the newcomer's path: install, three lines of CMake, a clipped image"
inside sh -c 'dpkg --install /debs/*.deb' >"$scratch/log" || { cat "$scratch/log"; exit 1; }
inside clipc --version
newcomer() {
  inside cmake -S /root/first -B "/root/$1" "${@:2}" >"$scratch/log" 2>&1 && inside cmake --build "/root/$1" >>"$scratch/log" 2>&1 ||
    { cat "$scratch/log"; exit 1; }
  inside "/root/$1/first" "/root/$1.ppm"
  [ "$(stat -c %s "$root/root/$1.ppm")" -eq $((13 + 3 * 64 * 64)) ] || fail "no image"
}
newcomer by_deb
inside sh -c 'cc -std=c99 /root/outside_c_project/main.c -o /root/embed $(pkg-config --cflags --libs clipc clipc-runtime)'
inside /root/embed

echo "-- what a scene needs"
inside clipc-study scene /root/harbour.json >"$scratch/log" || { cat "$scratch/log"; exit 1; }

echo "-- and nothing is left of it"
inside dpkg --remove clipc-study libclipc-dev libclipc1 clipc >/dev/null
left=$(find "$root/usr" "$root/etc" -name '*clipc*')
[ -z "$left" ] || fail "left behind: $left"

echo "-- the archive"
mkdir "$root/opt/clipc" && tar -xzf "$scratch"/clipc-*.tar.gz --strip-components=1 -C "$root/opt/clipc"
newcomer by_archive -DCMAKE_PREFIX_PATH=/opt/clipc
inside /opt/clipc/bin/clipc-study --help >/dev/null
echo "packages: passed"
