// Overloads share a name while GLSL can tell them apart: half and float, float1 and float, are the same there.
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=glsl120 --validate %s -o %t
// AUTOUPDATE
float f(float x) { return x; }
float f(half x) { return x * 2; }
float f(float2 x) { return x.x; }
float f(float2x2 x) { return x[0].x; }
float f(float4 x) { return x.x * 3; }
float f(float1x4 x) { return x[0].x * 4; }
float f(int x) { return x; }
float f(float x[2]) { return x[1]; }

float4 main(float4 p : POSITION) : SV_Position {
  float a[2] = { 1, 2 };
  return f(p.x) + f((half)p.x) + f(p.xy) + f((float2x2)p) + f(p) + f((float1x4)p) + f((int)p.x) + f(a);
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: int to_int(float x) {
// CHECK-NEXT:     return x < 2147483648.0 ? int(max(-2147483648.0, x)) : x > 0.0 ? 2147483647 : 0;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float f(float x) {
// CHECK-NEXT:     return x;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float f_2(float x) {
// CHECK-NEXT:     return x * 2.0;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float f(vec2 x) {
// CHECK-NEXT:     return x.x;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float f(mat2 x) {
// CHECK-NEXT:     return x[0].x;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float f(vec4 x) {
// CHECK-NEXT:     return x.x * 3.0;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float f_3(vec4 x) {
// CHECK-NEXT:     return x.x * 4.0;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float f(int x) {
// CHECK-NEXT:     return float(x);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float f(float x[2]) {
// CHECK-NEXT:     return x[1];
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     float a[2] = float[2](1.0, 2.0);
// CHECK-NEXT:     gl_Position = vec4(f(in_POSITION0.x) + f_2(in_POSITION0.x) + f(in_POSITION0.xy) + f(mat2(in_POSITION0.xy, in_POSITION0.zw)) + f(in_POSITION0) + f_3(in_POSITION0) + f(to_int(in_POSITION0.x)) + f(a));
// CHECK-NEXT: }
