// clamp(x, low, high) is min(max(x, low), high), also with a lower bound above the upper one, which GLSL and SPIR-V leave undefined. Bounds that are known the right way round, and unknown ones, are left to clamp.
// RUN: %draw compare %s -T vs_5_0
// RUN: %clipc %s -T vs_5_0 -o - | FileCheck %s
float4 main(float4 p : P, int2 i : I) : SV_Position {
  // CHECK: min(max(in_P0.x, 1.0), 0.0)
  // CHECK: min(max(in_P0.yz, vec2(0.0, 2.0)), vec2(1.0))
  // CHECK: min(max(in_I0.x, 5), -5)
  // CHECK: clamp(in_P0.w, 0.25, 0.25)
  return float4(clamp(p.x, 1, 0), clamp(p.yz, float2(0, 2), float2(1, 1)), clamp(i.x, 5, -5)) + clamp(p.w, 0.25, 0.25);
}
