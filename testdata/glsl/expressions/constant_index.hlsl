// A constant index of a vector is a component: Mesa 22.3 reads a.y for t[1] after `ivec2 t = a.yw`.
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// RUN: %draw compare %s -T vs_5_0
// CHECK: vs_A0 = t.y;
// CHECK: m[1].y = 2.0;
// CHECK-NOT: t[1]
float4 main(float4 p : POSITION, int4 a : A, out nointerpolation int o : A) : SV_Position {
  int2 t = a.yw;
  o = t[1];
  float3 m[2] = {p.xyz, p.yzw};
  m[1][1] = 2;
  return p + m[1].xyzx + m[0][2];
}
