// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=glsl150 --validate %s -o %t
// AUTOUPDATE
float4 main(float4 p : POSITION) : SV_Position {
  float r = 0.5 + 1 + 1e20 + 1e-7 + 0.1f + 3.14159265358979 + 16777216.0 - 2.0;
  r += -1.5 - -2.5;
  r *= asfloat(0x7fc00001);
  int i = -2147483647 - 1;
  i += 0x7fffffff;
  uint u = 0xffffffff + 7u;
  bool b = true;
  return p * r + i + u + b + float4(0, 0, 0, 0) + float4(1, 2, 3, 4);
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     float r = 0.5 + 1.0 + 1e+20 + 1e-07 + 0.1 + 3.1415927 + 16777216.0 - 2.0;
// CHECK-NEXT:     r += -1.5 - -2.5;
// CHECK-NEXT:     r *= uintBitsToFloat(2143289345u);
// CHECK-NEXT:     int i = -2147483647 - 1;
// CHECK-NEXT:     i = int(uint(i) + 2147483647u);
// CHECK-NEXT:     uint u = 4294967295u + 7u;
// CHECK-NEXT:     bool b = true;
// CHECK-NEXT:     gl_Position = in_POSITION0 * r + float(i) + float(u) + float(b) + vec4(0.0) + vec4(1.0, 2.0, 3.0, 4.0);
// CHECK-NEXT: }
