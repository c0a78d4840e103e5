// A second color for the blender where the target has none, and a number that is neither 0 nor 1.
// RUN: not %clipc %s -T ps_5_0 -E ps --target=glsl150 -o - 2>&1 | FileCheck %s
// RUN: not %clipc %s -T ps_5_0 -E third -o - 2>&1 | FileCheck %s --check-prefix=THIRD
// CHECK: [[#@LINE+2]]:85: error: `SV_Target1` is an input or output that target `glsl150` lacks [target-pixel-value]
// CHECK: note: target `glsl330` can
void ps(out float4 a : SV_Target0, [[vk::location(0), vk::index(1)]] out float4 b : SV_Target1) { a = b = 1; }
// THIRD: error: `vk::index` takes 0 or 1
void third([[vk::location(0), vk::index(2)]] out float4 a : SV_Target0) { a = 1; }
