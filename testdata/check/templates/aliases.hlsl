// Alias templates (DXC's CodeGenSPIRV/type.type-alias.template.hlsl).
// RUN: %clipc %s -T ps_6_0 -o - | FileCheck %s
// RUN: %draw compare %s -T ps_6_0
template<int N, typename T = float> struct Arr { T a[N]; };
template<int N> using A = Arr<N>;
template<typename T> using V = vector<T, 4>;
template<typename T, int N = 2> using List = T[N];
template<typename T> T First(A<2> x, T y) { return x.a[0] + y; }
float4 main(float4 p : P) : SV_Target {
  // CHECK: Arr x;
  A<2> x;
  x.a[0] = p.x;
  x.a[1] = 2;
  // CHECK: vec4 v = vs_P0;
  V<float> v = p;
  // CHECK: float list[3]
  List<float, 3> list = {1, 2, p.y};
  List<int> two = {3, 4};
  return v * First(x, 1.0) + x.a[1] + list[2] + two[1];
}
