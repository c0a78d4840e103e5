// Every kind of member of a buffer: where it lies by Direct3D's rules, and that the GLSL reads it there. The offsets were worked out a
// second time, from the rules' text. Without ALL, the shader reads neither doubles nor arrays of arrays,
// which clipc-draw does not feed.
// RUN: %clipc %s -T vs_6_0 -D ALL --target=vulkan -o /dev/null --reflect=- | grep -oE '"(name|offset)": [^,]+' | cut -d" " -f2 | tr -d '"' | paste -sd" " | FileCheck %s --check-prefixes=CHECK,COLUMN
// RUN: %clipc %s -T vs_6_0 -D ALL --target=vulkan -o /dev/null --reflect=- -Zpr | grep -oE '"(name|offset)": [^,]+' | cut -d" " -f2 | tr -d '"' | paste -sd" " | FileCheck %s --check-prefixes=CHECK,ROW
// CHECK: Vectors a 0 b 4 c 16 d 24 e 32 f 48 g 64 h 68
// CHECK-SAME: Arrays i 0 j 36 k 48 l 104
// COLUMN-SAME: Matrices m 0 n 44 o 48 p 76 q 80 r 96 s 112 t 160 u 216
// ROW-SAME: Matrices m 0 n 44 o 48 p 76 q 80 r 116 s 128 t 144 u 200
// CHECK-SAME: Structs v 0 w 16 x 364 y 368 z 436
// CHECK-SAME: Doubles aa 0 bb 8 cc 16 dd 40 ee 48
// CHECK-SAME: Texels ff 0 gg 16
// CHECK-SAME: hh 0
// RUN: %draw compare %s -T vs_6_0 --target all --exact --lower none | FileCheck %s --check-prefix=VALUES
// RUN: %draw compare %s -T vs_6_0 --row-major --target all --exact --lower none | FileCheck %s --check-prefix=VALUES
// VALUES: {{[1-9][0-9]*}} comparisons {{.*}}: 0 wrong

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
#ifdef ALL
cbuffer Doubles {
  float aa;
  double bb;
  double3 cc;
  float dd;
  double2 ee[2];
};
#endif
tbuffer Texels {
  float2 ff;
  float3 gg;
};
ConstantBuffer<Outer> hh[3];

float4 Sum(Inner inner) { return float4(inner.a, inner.b[1].z) + inner.b[0].xyzx + inner.c[0] - inner.c[1]; }
float4 Sum(Outer outer) { return Sum(outer.inner[0]) + Sum(outer.inner[1]) * outer.before + outer.behind.xyxy; }

struct Output {
  float4 position : SV_Position;
  float4 vectors : VECTORS;
  float4 arrays : ARRAYS;
  float4 matrices : MATRICES;
  float4 structs : STRUCTS;
  float4 others : OTHERS;
};

Output main(float4 position : POSITION) {
  Output result;
  result.position = position;
  result.vectors = float4(b, a) + float4(c, e) + f * (d ? 1 : 2) + float4(g, h, 0);
  result.arrays = float4(j, i[0]) + float4(i[1], i[2], l);
  result.matrices = float4(m[0], n) + float4(m[2].yzx, p) + float4(o[1], q[2].x) + float4(r[0], s[0].y) + t[0]._11_12_21_22 + t[1]._22_12_21_11 * u;
  result.structs = Sum(w[0]) + Sum(w[1]) * v + Sum(y) + float4(x, z, 0, 0);
  result.others = float4(gg, ff.y) + Sum(hh[0]) - Sum(hh[2]);
#ifdef ALL
  result.others += float4(float(bb + cc.y + ee[1].x), aa + dd, k[0][1].x, k[1][0].y);
#endif
  return result;
}
