// Names stay where GLSL lets them; keywords, built-in functions, `gl_` and `__` do not. Inputs and outputs are named first.
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=essl300 --validate %s -o %t
// RUN: %clipc -T vs_5_0 --target=glsl120 --validate %s -o %t
// AUTOUPDATE
cbuffer patch {
  float4 gl_color;
  float4 a__b;
  float4 distance;
  float4 in_POSITION0;
}
struct flat {
  float4 input;
  float4 texture;
  float4 smooth;
};
static float4 filter = 2;
float4 mix(float4 varying) { return varying * filter; }
float4 sampler2D_(float x) { float4 mat4 = x; return mat4; }
float helper(float saturate_) { return saturate(saturate_) + fmod(saturate_, 2); }
float fmod(float half_) { return half_; }

float4 main(float4 output : POSITION) : SV_Position {
  flat f = (flat)0;
  f.input = gl_color + a__b + distance + in_POSITION0;
  float length = 1;
  {
    float length = 2;
    f.texture += length;
  }
  for (int i = 0; i < 2; i++) f.smooth += i;
  for (int i = 0; i < 3; i++) f.smooth += i;
  { float4 first = 1; f.input += first; }
  { float4 first = 2; f.input += first; }
  return mix(f.input) + f.texture + f.smooth + length + sampler2D_(1) + helper(output.x) + fmod(1) + output;
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: struct flat_ {
// CHECK-NEXT:     vec4 input_;
// CHECK-NEXT:     vec4 texture;
// CHECK-NEXT:     vec4 smooth_;
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 0) uniform patch_ {  // b0
// CHECK-NEXT:     vec4 _gl_color;
// CHECK-NEXT:     vec4 a_b;
// CHECK-NEXT:     vec4 distance;
// CHECK-NEXT:     vec4 in_POSITION0;
// CHECK-NEXT: } patch_data;
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // output : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: float saturate(float x) {
// CHECK-NEXT:     return min(max(0.0, x), 1.0);  // 0 for NaN
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float fmod_2(float x, float y) {
// CHECK-NEXT:     return x - y * trunc(x / y);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 filter_ = vec4(2.0);
// CHECK-EMPTY:
// CHECK-NEXT: vec4 mix_(vec4 varying_) {
// CHECK-NEXT:     return varying_ * filter_;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 sampler2D_(float x) {
// CHECK-NEXT:     vec4 mat4_ = vec4(x);
// CHECK-NEXT:     return mat4_;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float helper(float saturate_) {
// CHECK-NEXT:     return saturate(saturate_) + fmod_2(saturate_, 2.0);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float fmod(float half_) {
// CHECK-NEXT:     return half_;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     flat_ f = flat_(vec4(0.0), vec4(0.0), vec4(0.0));
// CHECK-NEXT:     f.input_ = patch_data._gl_color + patch_data.a_b + patch_data.distance + patch_data.in_POSITION0;
// CHECK-NEXT:     float length_ = 1.0;
// CHECK-NEXT:     {
// CHECK-NEXT:         float length_2 = 2.0;
// CHECK-NEXT:         f.texture += length_2;
// CHECK-NEXT:     }
// CHECK-NEXT:     for (int i = 0; i < 2; i++) {
// CHECK-NEXT:         f.smooth_ += float(i);
// CHECK-NEXT:     }
// CHECK-NEXT:     for (int i = 0; i < 3; i++) {
// CHECK-NEXT:         f.smooth_ += float(i);
// CHECK-NEXT:     }
// CHECK-NEXT:     {
// CHECK-NEXT:         vec4 first = vec4(1.0);
// CHECK-NEXT:         f.input_ += first;
// CHECK-NEXT:     }
// CHECK-NEXT:     {
// CHECK-NEXT:         vec4 first = vec4(2.0);
// CHECK-NEXT:         f.input_ += first;
// CHECK-NEXT:     }
// CHECK-NEXT:     gl_Position = mix_(f.input_) + f.texture + f.smooth_ + length_ + sampler2D_(1.0) + helper(in_POSITION0.x) + fmod(1.0) + in_POSITION0;
// CHECK-NEXT: }
