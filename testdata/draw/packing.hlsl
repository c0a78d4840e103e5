// Where Direct3D's packing and std140 disagree, and where they do not.
// RUN: %draw compare %s -T vs_5_0 -E main --target all --exact --lower none | FileCheck %s
// CHECK: {{[1-9][0-9]+}} comparisons {{.*}}: 0 wrong
// CHECK-NOT: left out

cbuffer Scalars {
  float a;
  float3 b;
  float2 c;
  float d;
  bool e;
};
cbuffer AfterArray {
  float f[3];
  float g;
  float2 h[2];
  float2 i;
};
cbuffer AfterMatrix {
  float3x3 j;
  float k;
  float2x4 l;
  float2 m;
};
struct Inner {
  float3 n;
  float2 o;
};
cbuffer Structs {
  Inner p;
  float q;
  Inner r[2];
  float2 s;
};
cbuffer Packed {
  float4 t : packoffset(c3);
  float u : packoffset(c1.z);
  float2 v : packoffset(c0.y);
};
cbuffer Integers {
  int w;
  uint3 x;
  int2 y[2];
  int z;
};

struct Output {
  float4 position : SV_Position;
  float4 one : ONE;
  float4 two : TWO;
  float4 three : THREE;
  float4 four : FOUR;
  float4 five : FIVE;
};

Output main(float4 position : POSITION) {
  Output result;
  result.position = float4(b, a) + float4(c, d, e ? 1 : 0);
  result.one = float4(f[0], f[1], f[2], g) + float4(h[0], h[1]) * i.xyxy;
  result.two = float4(j[0], k) + float4(j[1], j[2].y) + l[1] + m.xyxy;
  result.three = float4(p.n, p.o.y) + float4(r[1].n, r[0].o.x) + float4(q, s, p.o.x);
  result.four = t + float4(u, v, 0);
  result.five = float4(w, x) + float4(y[1], y[0].y, z);
  return result;
}
