#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Puts the sources of Debian's LLVM 19, glslang and SPIRV-Tools, as far as cmake/cross/libraries.cmake takes them, into a folder.
#   cmake/cross/fetch_sources.sh [FOLDER]       build/sources
# They come by apt from where this machine's packages come from; its own lists of packages are left as they are. Nothing is
# done when they are there.
set -euo pipefail
cd "$(dirname "$0")/../.."
folder=${1:-build/sources}
[ ! -f "$folder/complete" ] || exit 0
mkdir -p "$folder"
folder=$(realpath "$folder")

# The machine's places of packages, as places of sources.
places=$folder/apt
mkdir -p "$places/parts" "$places/lists/partial" "$places/download"
for list in /etc/apt/sources.list.d/debian*.sources; do
  [ ! -f "$list" ] || sed 's/^Types:.*/Types: deb-src/' "$list" >"$places/parts/$(basename "$list")"
done
[ ! -f /etc/apt/sources.list ] || sed -n 's/^deb\(-src\)\? /deb-src /p' /etc/apt/sources.list >"$places/parts/main.list"
# apt's lists may name a place twice.
options=(-qq -o "Dir::Etc::SourceList=/dev/null" -o "Dir::Etc::SourceParts=$places/parts" -o "Dir::State::Lists=$places/lists"
  -o "APT::Get::Only-Source=true" -o "APT::Sandbox::User=$(id -un)")
apt-get "${options[@]}" update
(cd "$places/download" && apt-get "${options[@]}" source --download-only llvm-toolchain-19 glslang spirv-tools)

# unpack ARCHIVE FOLDER PATTERN...
unpack() {
  local archive=$1 to=$folder/$2
  shift 2
  rm -rf "$to"
  mkdir -p "$to"
  tar -xf "$archive" -C "$to" --strip-components=1 --wildcards "$@" --exclude='*/test/*'
}
unpack "$places"/download/llvm-toolchain-19_*.orig.tar.xz llvm-toolchain-19 '*/llvm/lib/Support/*' '*/llvm/lib/Demangle/*' \
  '*/llvm/lib/TargetParser/*' '*/clang/lib/Basic/*' '*/clang/lib/Lex/*' '*/clang/lib/Edit/*' '*/clang/lib/Frontend/*' \
  '*/libcxx/src/*' '*/libcxxabi/*' '*/libunwind/*'
unpack "$places"/download/glslang_*.orig.tar.gz glslang '*/glslang/*' '*/StandAlone/*' '*/OGLCompilersDLL/*'
unpack "$places"/download/spirv-tools_*.orig.tar.gz spirv-tools '*/include/*' '*/source/*' '*/utils/*'
rm -r "$places"
touch "$folder/complete"
