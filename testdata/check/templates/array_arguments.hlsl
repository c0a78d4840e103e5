// An array type is an argument of a template, as in C++ and DXC (template_base_this.hlsl of its tests has float[3] so).
// RUN: %clipc -T vs_6_0 -HV 2021 %s --validate -o - | FileCheck %s
// RUN: %draw compare %s -T vs_6_0
template <typename T> struct Holder { T held; };
template <typename T> float last(T x) { return x[1][2]; }
float4 main(float4 p : POSITION) : SV_Position {
  Holder<float[3]> h;
  // CHECK: float held[3];
  h.held[0] = p.x;
  h.held[1] = p.y;
  h.held[2] = p.z;
  float many[2][3] = { 1, 2, 3, 4, 5, p.w };
  return p + h.held[0] + h.held[2] * 2 + last<float[2][3]>(many);
}
