// Static variables start as zero; ES takes only constant initialisers, so the others are assigned first in main.
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=essl300 --validate %s -o - | FileCheck %s --check-prefix=ES
// RUN: %clipc -T vs_5_0 --target=glsl120 --validate %s -o %t
// AUTOUPDATE
static float counter;
static float4 color = { 1, 0.5, 0, 1 };
static const float kHalf = 0.5;
static const float3 kLight = normalize(float3(1, 2, 3)) * kHalf;
static const float kMod = fmod(-5.5, 2.0) + kHalf;
static const float4x4 kIdentity = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
static float values[2] = { kHalf, 2 };

float Count() {
  static int times = 3;
  const float step = kHalf * 2;
  times++;
  counter += step;
  return counter * times;
}
float4 main(float4 p : POSITION) : SV_Position {
  return mul(p, kIdentity) + Count() + color + kLight.x + kMod + values[1] + Count();
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: float fmod(float x, float y) {
// CHECK-NEXT:     return x - y * trunc(x / y);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float counter = 0.0;
// CHECK-NEXT: vec4 color = vec4(1.0, 0.5, 0.0, 1.0);
// CHECK-NEXT: const float kHalf = 0.5;
// CHECK-NEXT: const vec3 kLight = normalize(vec3(1.0, 2.0, 3.0)) * kHalf;
// CHECK-NEXT: float kMod = fmod(-5.5, 2.0) + kHalf;
// CHECK-NEXT: const mat4 kIdentity = mat4(vec4(1.0, 0.0, 0.0, 0.0), vec4(0.0, 1.0, 0.0, 0.0), vec4(0.0, 0.0, 1.0, 0.0), vec4(0.0, 0.0, 0.0, 1.0));
// CHECK-NEXT: float values[2] = float[2](kHalf, 2.0);
// CHECK-NEXT: int times = 3;
// CHECK-EMPTY:
// CHECK-NEXT: float Count() {
// CHECK-NEXT:     const float step_ = kHalf * 2.0;
// CHECK-NEXT:     times++;
// CHECK-NEXT:     counter += step_;
// CHECK-NEXT:     return counter * float(times);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     gl_Position = kIdentity * in_POSITION0 + Count() + color + kLight.x + kMod + values[1] + Count();
// CHECK-NEXT: }

// ES: #version 300 es
// ES-EMPTY:
// ES-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// ES-EMPTY:
// ES-NEXT: float fmod(float x, float y) {
// ES-NEXT:     return x - y * trunc(x / y);
// ES-NEXT: }
// ES-EMPTY:
// ES-NEXT: float counter = 0.0;
// ES-NEXT: vec4 color = vec4(1.0, 0.5, 0.0, 1.0);
// ES-NEXT: const float kHalf = 0.5;
// ES-NEXT: const vec3 kLight = normalize(vec3(1.0, 2.0, 3.0)) * kHalf;
// ES-NEXT: float kMod;
// ES-NEXT: const mat4 kIdentity = mat4(vec4(1.0, 0.0, 0.0, 0.0), vec4(0.0, 1.0, 0.0, 0.0), vec4(0.0, 0.0, 1.0, 0.0), vec4(0.0, 0.0, 0.0, 1.0));
// ES-NEXT: float values[2] = float[2](kHalf, 2.0);
// ES-NEXT: int times = 3;
// ES-EMPTY:
// ES-NEXT: float Count() {
// ES-NEXT:     const float step_ = kHalf * 2.0;
// ES-NEXT:     times++;
// ES-NEXT:     counter += step_;
// ES-NEXT:     return counter * float(times);
// ES-NEXT: }
// ES-EMPTY:
// ES-NEXT: void main() {
// ES-NEXT:     kMod = fmod(-5.5, 2.0) + kHalf;
// ES-NEXT:     gl_Position = kIdentity * in_POSITION0 + Count() + color + kLight.x + kMod + values[1] + Count();
// ES-NEXT: }
