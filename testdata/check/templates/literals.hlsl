// A literal becomes what the other arguments of a template are; alone it is what it is.
// RUN: %clipc -T vs_6_0 %s --validate | FileCheck %s
// RUN: %draw compare %s -T vs_6_0
template<typename T> T larger(T a, T b) { return a > b ? a : b; }
template<typename T> T twice(T a) { return a + a; }
float4 main(float4 p : P, int i : I) : SV_Position {
  // CHECK: larger(0.0, in_P0.x * 0.5) + larger(in_P0.y, -2.0) + float(larger(in_I0, 1))
  float x = larger(0, p.x * 0.5) + larger(p.y, -2) + larger(i, 1);
  // CHECK: twice(3)
  return float4(x, twice(3), larger<float>(i, 2.5), 1);
}
