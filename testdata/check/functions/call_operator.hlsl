// A struct may have operator() and operator[]: HLSL 2021's operator overloading (DXC's specification "Operator Overloading", which names
// both among those that may be overloaded).
// RUN: %clipc -T vs_6_0 -HV 2021 %s --validate -o - | FileCheck %s
// RUN: %draw compare %s -T vs_6_0
struct Scale {
  float k;
  float operator()(float x) { return x * k; }
  float operator()(float x, float y) { return x * k + y; }
  float operator[](int i) { return k + i; }
};
struct Outer { Scale inner; };
static Scale all[2];
Scale make(float k) { Scale s = { k }; return s; }
float4 main(float4 p : POSITION) : SV_Position {
  Scale s = { 2 };
  Outer o;
  o.inner.k = p.x;
  all[0].k = p.y;
  all[1].k = p.z;
  // CHECK: s, 3.0) + {{.*}}s, 3.0, {{.*}}.x) + {{.*}}s, 2)
  float sum = s(3) + s(3, p.x) + s[2];
  sum += o.inner(p.w) + all[1](4) + make(5)(p.x) + o.inner[1];
  return p + sum;
}
