#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Builds clipc as it is packaged, in build/profiled: compiled by what an earlier build of it ran on the shaders of
# examples/gallery, and on the pixel shaders and pairs of testdata/draw/pairs. Needs g++.
#   cmake/build_profiled.sh [TARGET...]      all targets of the build, or these
set -euo pipefail
cd "$(dirname "$0")/.."
. cmake/setup.sh
install_packages "${build_packages[@]}"

folder=build/profiled
# configure record|use
configure() {
  quietly cmake --preset release -B "$folder" -DBUILD_TESTING=OFF -DCLIPC_LLVM="$llvm" -DCLIPC_PROFILE="$1"
}
configure record
find "$folder" -name '*.gcda' -delete
build_preset profiled --target clipc -- --quiet >&2

# The gallery has vertex shaders as people write them, and testdata/draw/pairs small pixel shaders. Other shaders of testdata try
# limits, and would count for more than all of these.
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
for target in glsl450 glsl330 essl300 vulkan; do
  for lowering in clip-distance discard none; do
    "$folder/bin/clipc" -T vs_5_0 --target="$target" --lower="$lowering" --no-validate examples/gallery/*.hlsl -o "$scratch" \
      >/dev/null 2>&1 || true
  done
  "$folder/bin/clipc" -T ps_5_0 -E ps --target="$target" --no-validate testdata/draw/pairs/*.hlsl -o "$scratch" >/dev/null 2>&1 || true
  "$folder/bin/clipc" -E vs --pixel-entry=ps --pixel-output=.frag --target="$target" --no-validate testdata/draw/pairs/*.hlsl \
    -o "$scratch" >/dev/null 2>&1 || true
done
[ -n "$(find "$folder" -name '*.gcda' -print -quit)" ] || {
  echo "cmake/build_profiled.sh: the recording program wrote no notes" >&2
  exit 1
}

configure use
[ $# -gt 0 ] || set -- all
build_preset profiled --target "$@" -- --quiet >&2
