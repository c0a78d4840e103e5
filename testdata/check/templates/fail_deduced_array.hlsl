// Two arrays of different sizes do not have one bound.
// RUN: not %clipc -T ps_6_0 -HV 2021 %s 2>&1 | FileCheck %s
template <typename T, int N>
T Last(T a[N], T b[N]) { return a[N - 1] + b[N - 1]; }

float4 main(float4 p : P) : SV_Target {
  float3 two[2] = {p.xyz, p.yzw};
  float3 three[3] = {p.xyz, p.yzw, p.zwx};
  // CHECK: [[#@LINE+1]]:10: error: no function `Last` takes (float3[3], float3[2]) [no-matching-function, X3013]
  return Last(three, two).xyzz;
}
