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

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: struct Inner {
// CHECK-NEXT:     float a;
// CHECK-NEXT:     vec3 b;
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: struct Outer {
// CHECK-NEXT:     Inner inner[2];
// CHECK-NEXT:     float long_one[20];
// CHECK-NEXT:     float table[2][3];
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 0) uniform Buffer {  // b0
// CHECK-NEXT:     vec4 outers_rows[84];
// CHECK-NEXT: } buffer_;
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-NEXT: layout(location = 1) in int in_INDEX0;  // i : INDEX0
// CHECK-EMPTY:
// CHECK-NEXT: float[20] load_outers_rows(int at) {
// CHECK-NEXT:     float result[20];
// CHECK-NEXT:     for (int i_2 = 0; i_2 < 20; ++i_2) {
// CHECK-NEXT:         result[i_2] = buffer_.outers_rows[at + i_2].x;
// CHECK-NEXT:     }
// CHECK-NEXT:     return result;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: Outer outers(int i) {  // offset 0
// CHECK-NEXT:     return Outer(Inner[2](Inner(buffer_.outers_rows[28 * i].x, buffer_.outers_rows[28 * i].yzw), Inner(buffer_.outers_rows[28 * i + 1].x, buffer_.outers_rows[28 * i + 1].yzw)), load_outers_rows(28 * i + 2), float[2][3](float[3](buffer_.outers_rows[28 * i + 22].x, buffer_.outers_rows[28 * i + 23].x, buffer_.outers_rows[28 * i + 24].x), float[3](buffer_.outers_rows[28 * i + 25].x, buffer_.outers_rows[28 * i + 26].x, buffer_.outers_rows[28 * i + 27].x)));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     Outer outer = outers(in_INDEX0);
// CHECK-NEXT:     gl_Position = in_POSITION0 + outer.inner[1].b.xyzx + outer.long_one[in_INDEX0] + outers(2).table[1][in_INDEX0] + outers(in_INDEX0 + 1).inner[0].a;
// CHECK-NEXT: }
