// Swizzles of vectors, scalars and matrices, as values and as targets; indices.
// RUN: %clipc -T vs_5_0 -E main --dump=ir %s | FileCheck %s
cbuffer C { float4x3 m; float4 list[4]; int n; };
float4 main(float4 v : POSITION) : SV_Position {
  // CHECK: float4 a = v.wzyx
  float4 a = v.abgr;
  // CHECK: float2 b = v.zx
  float2 b = v.xyz.zx;
  // CHECK: float3 c = splat<float3>(v.x)
  float3 c = v.x.xxx;
  // CHECK: float d = m[1u][2u]
  float d = m._m12;
  // CHECK: float3 e = m._m00_m11_m22
  float3 e = m._11_22_33;
  // CHECK: float2 f = m[3u].yx
  float2 f = m._42_41;
  float4x4 t = 0;
  // CHECK: float2 temporary = v.xy
  // CHECK-NEXT: t[0u][0u] = temporary.x
  // CHECK-NEXT: t[1u][1u] = temporary.y
  t._m00_m11 = v.xy;
  // CHECK: t[2][1] = 1.0
  t[2][1] = 1;
  // CHECK: t[2u].xy += splat<float2>(2.0)
  t._31_32 += 2;
  // CHECK: v[n] = list[n + 1][n & 3]
  v[n] = list[n + 1][n & 3];
  // CHECK: v.y = 4.0
  v.xy[1] = 4;
  // CHECK: v.x = list[convert<int>(v.z)].x
  v.x = list[v.z].x;
  return a + b.xyxy + c.xyzz + d + e.xyzz + f.xyxy + t[0];
}
