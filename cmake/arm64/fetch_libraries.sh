#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Puts the libraries that clipc is linked with, as Debian has them for 64-bit ARM, into a folder.
#   cmake/arm64/fetch_libraries.sh [FOLDER]       build/arm64-root
# They come by apt from where this machine's packages come from. Nothing is installed: this machine's own architectures, packages and
# lists of packages are left as they are. Nothing is done when they are there.
set -euo pipefail
cd "$(dirname "$0")/../.."
. cmake/setup.sh
folder=${1:-build/arm64-root}
[ ! -f "$folder/complete" ] || exit 0
mkdir -p "$folder"/apt/{lists/partial,cache/archives/partial,download}
folder=$(realpath "$folder")
: >"$folder/apt/status" # no package is installed
options=(-qq -o APT::Architecture=arm64 -o APT::Architectures=arm64 -o "Dir::State::Status=$folder/apt/status"
  -o "Dir::State::Lists=$folder/apt/lists" -o "Dir::Cache=$folder/apt/cache" -o "APT::Sandbox::User=$(id -un)")
apt-get "${options[@]}" update
# fmt's files for CMake name the shared library too, whose package has a number in its name.
fmt=$(apt-cache "${options[@]}" depends libfmt-dev | sed -nE 's/.*Depends: (libfmt[0-9]+)$/\1/p')
(cd "$folder/apt/download" && apt-get "${options[@]}" download "libclang-$llvm-dev" "llvm-$llvm-dev" libfmt-dev "$fmt" glslang-dev \
  spirv-tools nlohmann-json3-dev spirv-headers)
for package in "$folder"/apt/download/*.deb; do dpkg-deb -x "$package" "$folder"; done
rm -r "$folder/apt"
touch "$folder/complete"
