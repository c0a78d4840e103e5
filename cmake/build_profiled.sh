#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Builds clipc as it is packaged, in build/profiled: compiled by what an earlier build of it ran on the shaders of
# examples/gallery, examples/pixel and examples/compute, and on the pairs of testdata/draw/pairs; linked with the functions that a short run calls
# side by side, so that a start reads few pages. Needs g++.
#   cmake/build_profiled.sh [TARGET...]      all targets of the build, or these
set -euo pipefail
cd "$(dirname "$0")/.."
. cmake/setup.sh
install_packages "${build_packages[@]}" "lld-$llvm" valgrind

folder=build/profiled
order=$PWD/$folder/link_order.txt
# configure record|use ORDER
configure() {
  quietly cmake --preset release -B "$folder" -DBUILD_TESTING=OFF -DCLIPC_LLVM="$llvm" -DCLIPC_PROFILE="$1" -DCLIPC_LINK_ORDER="$2"
}
configure record ""
find "$folder" -name '*.gcda' -delete
build_preset profiled --target clipc -- --quiet >&2

# These examples have shaders as people write them, and testdata/draw/pairs pairs of them. Other shaders of
# testdata try limits, and would count for more than all of these.
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
for output in --target=glsl450 --target=glsl330 --target=essl300 --target=vulkan -spirv; do
  for lowering in clip-distance discard none; do
    "$folder/bin/clipc" -T vs_5_0 "$output" --lower="$lowering" examples/gallery/*.hlsl -o "$scratch" >/dev/null 2>&1 || true
  done
  for profile in ps_4_1 ps_5_0 ps_5_1; do
    "$folder/bin/clipc" -T "$profile" "$output" examples/pixel/*.hlsl -o "$scratch" >/dev/null 2>&1 || true
  done
  "$folder/bin/clipc" -T cs_5_0 "$output" examples/compute/*.hlsl -o "$scratch" >/dev/null 2>&1 || true
  "$folder/bin/clipc" -T ps_5_0 -E ps "$output" testdata/draw/pairs/*.hlsl -o "$scratch" >/dev/null 2>&1 || true
  "$folder/bin/clipc" -E vs --pixel-entry=ps --pixel-output=.frag "$output" testdata/draw/pairs/*.hlsl \
    -o "$scratch" >/dev/null 2>&1 || true
done
[ -n "$(find "$folder" -name '*.gcda' -print -quit)" ] || {
  echo "cmake/build_profiled.sh: the recording program wrote no notes" >&2
  exit 1
}

configure use ""
build_preset profiled --target clipc -- --quiet >&2

# functions_of ARGUMENT...: the symbols of what `clipc ARGUMENT...` calls.
functions_of() {
  valgrind --quiet --tool=callgrind --demangle=no --callgrind-out-file="$scratch/calls" "$folder/bin/clipc" "$@" -o "$scratch/out" >&2
  sed -nE "s/^c?fn=\([0-9]+\) ([^']+).*/\1/p" "$scratch/calls"
}
shaders=tools/checks/instructions
{
  functions_of -T vs_5_0 "$shaders/vertex.hlsl"
  functions_of -T ps_5_0 "$shaders/pixel.hlsl"
  functions_of -spirv -T vs_5_0 "$shaders/vertex.hlsl"
  functions_of -spirv -T ps_5_0 "$shaders/pixel.hlsl"
} | awk '!seen[$0]++' >"$order"

configure use "$order"
[ $# -gt 0 ] || set -- all
build_preset profiled --target "$@" -- --quiet >&2
