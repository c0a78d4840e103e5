// Offsets and sizes of every kind of member, held against Direct3D's rules once more.
// RUN: %python %S/../../tools/bench/check_packing.py %clipc --shader %s -T vs_6_0 | FileCheck %s
// RUN: %python %S/../../tools/bench/check_packing.py %clipc --shader %s -T vs_6_0 -Zpr | FileCheck %s
// CHECK: 1 shaders, 34 members of buffers: 0 wrong

struct Inner {
  float3 a;
  row_major float2x3 b;
  float c[2];
};
struct Outer {
  float before;
  Inner inner[2];
  float2 behind;
};
cbuffer Vectors {
  float a;
  float3 b;
  float2 c;
  bool d;
  int2 e;
  uint4 f;
  half g;
  min16float2 h;
};
cbuffer Arrays {
  float i[3];
  float3 j;
  float2 k[2][2];
  float2 l;
};
cbuffer Matrices {
  float3x3 m;
  float n;
  row_major float2x3 o;
  float p;
  float3x1 q;
  row_major float1x3 r;
  float1x3 s;
  float2x2 t[2];
  float u;
};
cbuffer Structs {
  float v;
  Outer w[2];
  float x;
  Inner y;
  float z;
};
cbuffer Doubles {
  float aa;
  double bb;
  double3 cc;
  float dd;
  double2 ee[2];
};
tbuffer Texels {
  float2 ff;
  float3 gg;
};
ConstantBuffer<Outer> hh[3];

float4 main(float4 position : POSITION) : SV_Position {
  return position * a + i[0] + m[0].x + v + float(bb) + ff.x + hh[1].before;
}
