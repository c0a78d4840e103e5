#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Builds clipc as it is packaged, in build/profiled: compiled by what an earlier build of it ran on the shaders of testdata and
# examples. It is a fifth faster than build/release. Needs g++.
#   cmake/build_profiled.sh [TARGET...]      all targets of the build, or these
set -euo pipefail
cd "$(dirname "$0")/.."
. cmake/setup.sh
install_packages "${build_packages[@]}"

folder=build/profiled
# configure record|use
configure() {
  quietly cmake --preset release -B "$folder" -DBUILD_TESTING=OFF -DCLIPC_LLVM="$llvm" -DCMAKE_UNITY_BUILD=ON \
    -DCMAKE_UNITY_BUILD_BATCH_SIZE=6 -DCLIPC_PROFILE="$1"
}
configure record
find "$folder" -name '*.gcda' -delete
build_preset profiled --target clipc -- --quiet >&2

# Shaders with errors are compiled too: messages are a part of what clipc does. Folder by folder, as names of files are of one.
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
find testdata examples -name '*.hlsl' -printf '%h\n' | sort -u | while read -r shaders; do
  for target in glsl450 glsl330 essl300 vulkan; do
    "$folder/bin/clipc" -T vs_5_0 --target="$target" --no-validate "$shaders"/*.hlsl -o "$scratch" >/dev/null 2>&1 || true
  done
done
[ -n "$(find "$folder" -name '*.gcda' -print -quit)" ] || {
  echo "cmake/build_profiled.sh: the recording program wrote no notes" >&2
  exit 1
}

configure use
[ $# -gt 0 ] || set -- all
build_preset profiled --target "$@" -- --quiet >&2
