// The bounds and the element of an array parameter are deduced: an array does not become a pointer (DXC's SemaTemplateDeduction.cpp).
// RUN: %clipc -T ps_6_0 -HV 2021 %s -o - | FileCheck %s
// RUN: %draw compare %s -T ps_6_0
template <typename T, int N>
T Sum(T values[N]) {
  T sum = (T)0;
  for (int i = 0; i < N; ++i)
    sum += values[i];
  return sum;
}
template <typename T, uint N, uint M>
T Corner(vector<T, M> values[N][M]) { return values[N - 1][M - 1][M - 1]; }
template <typename T, int N>
T Last(T a[N], T b[N]) { return a[N - 1] + b[N - 1]; }

// CHECK: vec3 Sum{{.*}}(vec3 values[2])
// CHECK: i < 2
// CHECK: float Corner{{.*}}(vec2 values[3][2])
// CHECK: float Last{{.*}}(float a[3], float b[3])
float4 main(float4 p : P) : SV_Target {
  float3 two[2] = {p.xyz, p.yzw};
  float2 six[3][2] = {p.xy, p.yz, p.zw, p.wx, p.xz, p.yw};
  float three[3] = {p.xyz};
  return Sum(two).xyzz + Corner(six) + Last(three, three);
}
