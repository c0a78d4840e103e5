// A struct in rows is put together whole; long arrays are filled by a loop.
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=glsl330 --validate %s -o %t
// AUTOUPDATE
struct Inner {
  float a;
  float3 b;
};
struct Outer {
  Inner inner[2];
  float long_one[20];
  float table[2][3];
};
cbuffer Buffer { Outer outers[3]; }

float4 main(float4 p : POSITION, int i : INDEX) : SV_Position {
  Outer outer = outers[i];
  return p + outer.inner[1].b.xyzx + outer.long_one[i] + outers[2].table[1][i] + outers[i + 1].inner[0].a;
}
