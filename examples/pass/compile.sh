#!/bin/sh
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Compiles a vertex shader with clip planes to SPIR-V by a compiler that drops them, with clipc before it.
#   compile.sh glslang|glslc|dxc|slangc SHADER.hlsl ENTRY OUTPUT.spv
# CLIPC names clipc, and COMPILER the compiler, where they are not found by their names.
set -eu
tool=$1 shader=$2 entry=$3 output=$4
folder=$(dirname "$shader") # the includes of the shader are there

case $tool in
glslang | glslc | dxc | slangc) ;;
*) echo "compile.sh: there is no \`$tool\`; glslang, glslc, dxc and slangc are known" >&2 && exit 2 ;;
esac
hlsl=${output%.spv}.clipped.hlsl
"${CLIPC:-clipc}" "$shader" -E "$entry" --target=hlsl -o "$hlsl"

case $tool in
glslang) "${COMPILER:-glslangValidator}" -D -V -S vert -e "$entry" -I"$folder" "$hlsl" -o "$output" ;;
glslc) "${COMPILER:-glslc}" -x hlsl -fshader-stage=vert -fentry-point="$entry" -I "$folder" "$hlsl" -o "$output" ;;
dxc) "${COMPILER:-dxc}" -spirv -T vs_6_0 -E "$entry" -I "$folder" "$hlsl" -Fo "$output" ;;
slangc) "${COMPILER:-slangc}" "$hlsl" -target spirv -entry "$entry" -stage vertex -I "$folder" -o "$output" ;;
esac
