// A function of the shader's with an intrinsic's name is called wherever it can take the arguments (vkd3d's test of overridden
// intrinsics, checked against native). DXC, from shader model 6.0 on, prefers the intrinsic wherever that can take them.
// RUN: %clipc -T vs_5_0 %s --validate | FileCheck %s --check-prefixes=CHECK,FXC
// RUN: %clipc -T vs_6_0 %s --validate | FileCheck %s --check-prefixes=CHECK,DXC
float2 max(float2 a, float2 b) { return a + b; }
float2 min(float2 a, float3 b) { return a + b.xy; }
float4 main(float4 p : POSITION) : SV_Position {
  // FXC: float x = max_(vec2(in_POSITION0.x), vec2(in_POSITION0.y)).x;
  // DXC: float x = max(in_POSITION0.x, in_POSITION0.y);
  float x = max(p.x, p.y);
  // FXC: vec2 y = max_(in_POSITION0.xy, in_POSITION0.zw);
  // DXC: vec2 y = max(in_POSITION0.xy, in_POSITION0.zw);
  float2 y = max(p.xy, p.zw);
  // CHECK: vec2 z = min(in_POSITION0.xy, in_POSITION0.zw);
  float2 z = min(p.xy, p.zw);
  return float4(x, y + z, 1);
}
