// RUN: %clipc -T vs_5_0 -E main --dump=ir -Wno-implicit-truncation %s | FileCheck %s
struct Four { float2 a; float b[2]; };
float4 main(float4 v : POSITION, int i : INDEX) : SV_Position {
  // CHECK: float4 a = float4(v.xy, convert<float>(i), 1.0)
  float4 a = float4(v.xy, i, 1);
  // CHECK: float3x3 b = float3x3(v.xyz, v.yzw, float3(1.0, 2.0, 3.0))
  float3x3 b = float3x3(v.xyz, v.yzw, 1, 2, 3);
  // CHECK: float2x2 c = float2x2(v.x, v.y, v.z, 1.0)
  float2x2 c = float2x2(v.xyz, 1);
  // CHECK: float4 d = float4(c[0u].x, c[0u].y, c[1u].x, c[1u].y)
  float4 d = float4(c);
  // CHECK: float3x3 e = truncate<float3x3>(
  float3x3 e = (float3x3)float4x4(v, v, v, v);
  // CHECK: Four f = Four{v.xy, float[2]{v.z, v.w}}
  Four f = (Four)v;
  // CHECK: int2 g = convert<int2>(v.xy)
  int2 g = int2(v.xy);
  // CHECK: float h = v.x
  float h = (float)v;
  // CHECK: Four j = zero<Four>
  Four j = (Four)0;
  return a + b[0].xyzz + d + e[1].xyzz + f.b[1] + g.x + h + j.a.x;
}
