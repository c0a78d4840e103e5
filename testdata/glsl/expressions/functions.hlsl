// Callees come first, whatever the order in the source; what main does not reach is not written. `main` is GLSL's own.
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 -E entry --validate %s -o - | FileCheck %s --check-prefix=ENTRY
// AUTOUPDATE
float First(float x);
float Unreached(float x) { return x; }
float Second(float x) { return First(x) * 2; }
float First(float x) { return x + 1; }
struct Unused { float x; };
float4 unused_uniform;
static float4 unused_static = 3;
void Both(in float a, inout float b, out float c) {
  c = a;
  b += a;
  a = 0;
}
void Nothing() {}

float4 main(float4 p : POSITION) : SV_Position {
  float x = Second(p.x), y;
  Both(p.y, x, y);
  Nothing();
  Both(1, p.z, p[3]);
  return p * x + y;
}
float4 entry(float4 p : POSITION) : SV_Position { return main(p); }

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: float First(float x) {
// CHECK-NEXT:     return x + 1.0;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float Second(float x) {
// CHECK-NEXT:     return First(x) * 2.0;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void Both(float a, inout float b, out float c) {
// CHECK-NEXT:     c = a;
// CHECK-NEXT:     b += a;
// CHECK-NEXT:     a = 0.0;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void Nothing() {
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     vec4 p = in_POSITION0;
// CHECK-NEXT:     float x = Second(p.x);
// CHECK-NEXT:     float y;
// CHECK-NEXT:     Both(p.y, x, y);
// CHECK-NEXT:     Nothing();
// CHECK-NEXT:     Both(1.0, p.z, p.w);
// CHECK-NEXT:     gl_Position = p * x + y;
// CHECK-NEXT: }

// ENTRY: #version 450
// ENTRY-EMPTY:
// ENTRY-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// ENTRY-EMPTY:
// ENTRY-NEXT: float First(float x) {
// ENTRY-NEXT:     return x + 1.0;
// ENTRY-NEXT: }
// ENTRY-EMPTY:
// ENTRY-NEXT: float Second(float x) {
// ENTRY-NEXT:     return First(x) * 2.0;
// ENTRY-NEXT: }
// ENTRY-EMPTY:
// ENTRY-NEXT: void Both(float a, inout float b, out float c) {
// ENTRY-NEXT:     c = a;
// ENTRY-NEXT:     b += a;
// ENTRY-NEXT:     a = 0.0;
// ENTRY-NEXT: }
// ENTRY-EMPTY:
// ENTRY-NEXT: void Nothing() {
// ENTRY-NEXT: }
// ENTRY-EMPTY:
// ENTRY-NEXT: vec4 shader_main(vec4 p) {
// ENTRY-NEXT:     float x = Second(p.x);
// ENTRY-NEXT:     float y;
// ENTRY-NEXT:     Both(p.y, x, y);
// ENTRY-NEXT:     Nothing();
// ENTRY-NEXT:     Both(1.0, p.z, p.w);
// ENTRY-NEXT:     return p * x + y;
// ENTRY-NEXT: }
// ENTRY-EMPTY:
// ENTRY-NEXT: void main() {
// ENTRY-NEXT:     gl_Position = shader_main(in_POSITION0);
// ENTRY-NEXT: }
