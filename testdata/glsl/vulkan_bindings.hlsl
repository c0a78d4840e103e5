// Registers of all kinds share a set's bindings: b at 0, s at 16, t at 32; the space is the set.
// RUN: %clipc -T vs_5_1 --target=vulkan --validate %s -o - | FileCheck %s
// AUTOUPDATE
cbuffer Scene : register(b3, space1) { float4x4 view; }
Texture2D heights : register(t2);
SamplerState linear_clamp : register(s1);
StructuredBuffer<float4> points : register(t3);

float4 main(float4 p : POSITION, uint i : INDEX) : SV_Position {
  p.y += heights.SampleLevel(linear_clamp, p.xz, 0).x;
  return mul(p + points[i], view);
}
