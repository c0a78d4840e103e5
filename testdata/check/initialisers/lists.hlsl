// A list is one row of components, however its braces nest.
// RUN: %clipc -T vs_5_0 -E main --dump=ir %s | FileCheck %s
struct Inner { float2 a; int b; };
struct Outer { Inner inner[2]; float c; };
// CHECK: const float2 kCorners[4] = float2[4]{float2(0.0, 0.0), float2(1.0, 0.0), float2(0.0, 1.0), float2(1.0, 1.0)}
static const float2 kCorners[] = {float2(0, 0), {1, 0}, 0, 1, {float2(1, 1)}};
// CHECK: const float4x4 kIdentity = float4x4(float4(1.0, 0.0, 0.0, 0.0), float4(0.0, 1.0, 0.0, 0.0)
static const float4x4 kIdentity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
float4 main(float4 v : POSITION) : SV_Position {
  // CHECK: float4 a = float4(v.xyz, 1.0)
  float4 a = {v.xyz, 1};
  // CHECK: Outer b = Outer{Inner[2]{Inner{v.xy, 1}, Inner{float2(2.0, 3.0), 4}}, 5.0}
  Outer b = {v.xy, 1, {{2, 3}, 4}, 5};
  // CHECK: float2 c[2] = float2[2]{float2(v.x, v.y), float2(v.z, v.w)}
  float2 c[2] = {v};
  // CHECK: float d[3] = float[3]{b.inner[1].a.x, b.inner[1].a.y, convert<float>(b.inner[1].b)}
  float d[3] = {b.inner[1]};
  // CHECK: Inner e[1] = Inner[1]{b.inner[0]}
  Inner e[] = {b.inner[0]};
  return a + c[1].xyxy + d[2] + e[0].a.x + kCorners[3].xyxy + kIdentity[1];
}
