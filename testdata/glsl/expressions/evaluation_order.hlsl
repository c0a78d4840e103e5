// inout arguments are copied in and out; a compound assignment evaluates its target once.
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// AUTOUPDATE
static float global = 1;
float Change(inout float x, float y) {
  x += 1;
  global += x;
  return x * y;
}
float4 main(float4 p : POSITION, int i : INDEX) : SV_Position {
  float v[3] = { 1, 2, 3 };
  v[i++] += 2;
  v[i++] %= 2;
  float r = Change(global, global) + Change(v[i], 2);
  float4 q = p;
  Change(q.y, q[i]);
  r = q.x = q.y += 3;
  return q * r + v[0] * (i++ , i);
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-NEXT: layout(location = 1) in int in_INDEX0;  // i : INDEX0
// CHECK-EMPTY:
// CHECK-NEXT: float fmod(float x, float y) {
// CHECK-NEXT:     return x - y * trunc(x / y);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float assign_modulo(inout float target, float value) {
// CHECK-NEXT:     target = fmod(target, value);
// CHECK-NEXT:     return target;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float global = 1.0;
// CHECK-EMPTY:
// CHECK-NEXT: float Change(inout float x, float y) {
// CHECK-NEXT:     x += 1.0;
// CHECK-NEXT:     global += x;
// CHECK-NEXT:     return x * y;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     int i = in_INDEX0;
// CHECK-NEXT:     float v[3] = float[3](1.0, 2.0, 3.0);
// CHECK-NEXT:     v[i++] += 2.0;
// CHECK-NEXT:     assign_modulo(v[i++], 2.0);
// CHECK-NEXT:     float r = Change(global, global) + Change(v[i], 2.0);
// CHECK-NEXT:     vec4 q = in_POSITION0;
// CHECK-NEXT:     Change(q.y, q[i]);
// CHECK-NEXT:     r = q.x = q.y += 3.0;
// CHECK-NEXT:     gl_Position = q * r + v[0] * float((i++, i));
// CHECK-NEXT: }
