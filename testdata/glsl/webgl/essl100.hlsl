// OpenGL ES 2 and WebGL 1: attributes, varyings, constant buffers as arrays of rows and members of integers beside them;
// structs for arrays and for matrices that are not square, helper functions for what GLSL ES 1.00 lacks.
// RUN: %clipc -T vs_5_0 --target=essl100 --lower=near-plane --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=webgl1 --lower=near-plane --validate %s -o - | FileCheck %s
// RUN: %draw compare %s -T vs_5_0 --target essl100,glsl450 --lower discard --ints 0..3
// AUTOUPDATE
struct Light {
  float3 color;
  float weights[2];
};
cbuffer Frame {
  float4x4 world;
  row_major float4x4 view;
  float4x3 bones[4];
  Light light;
  int count;
  float4 water;
  float4 last_one_unread[20];
};
cbuffer Flags {
  bool fog;
};
struct Output {
  float4 position : SV_Position;
  float3 normal : NORMAL;
};
static const float2 corners[3] = {float2(0, 0), float2(1, 0), float2(0, 1)};

[clipplanes(water)]
Output main(float4 p : POSITION, int4 indices : BLENDINDICES, float4 weights : BLENDWEIGHT, float3 n : NORMAL) {
  Output o;
  float3 skinned = 0;
  for (int i = 0; i < 4; ++i) skinned += mul(p, bones[indices[i]]) * weights[i];
  float values[3];
  int k;
  for (k = 0; k < 3 && k < count; k++) values[k] = k;
  values[indices.x] += light.weights[1];
  float3x3 rotation = (float3x3)world;
  o.normal = mul(mul(n, transpose(rotation)), rotation) + values[0] + corners[indices.y].xyx;
  if (fog) o.normal *= light.color;
  o.position = mul(mul(float4(skinned, 1), world), view);
  return o;
}

// CHECK: #version 100
// CHECK-EMPTY:
// CHECK-NEXT: struct vec3_array4 {
// CHECK-NEXT:     vec3 e0, e1, e2, e3;
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: struct float_array2 {
// CHECK-NEXT:     float e0, e1;
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: struct Light {
// CHECK-NEXT:     vec3 color;
// CHECK-NEXT:     float_array2 weights;
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: struct vec2_array3 {
// CHECK-NEXT:     vec2 e0, e1, e2;
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: struct float_array3 {
// CHECK-NEXT:     float e0, e1, e2;
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: uniform vec4 Frame[24];  // b0
// CHECK-NEXT: uniform int count;
// CHECK-EMPTY:
// CHECK-NEXT: // Flags, b1
// CHECK-NEXT: uniform bool fog;
// CHECK-EMPTY:
// CHECK-NEXT: attribute vec4 in_POSITION0;  // p : POSITION0
// CHECK-NEXT: attribute vec4 in_BLENDINDICES0;  // indices : BLENDINDICES0
// CHECK-NEXT: attribute vec4 in_BLENDWEIGHT0;  // weights : BLENDWEIGHT0
// CHECK-NEXT: attribute vec3 in_NORMAL0;  // n : NORMAL0
// CHECK-EMPTY:
// CHECK-NEXT: varying vec3 vs_NORMAL0;  // normal : NORMAL0
// CHECK-EMPTY:
// CHECK-NEXT: mat4 world() {  // offset 0
// CHECK-NEXT:     return mat4(vec4(Frame[0].x, Frame[1].x, Frame[2].x, Frame[3].x), vec4(Frame[0].y, Frame[1].y, Frame[2].y, Frame[3].y), vec4(Frame[0].z, Frame[1].z, Frame[2].z, Frame[3].z), vec4(Frame[0].w, Frame[1].w, Frame[2].w, Frame[3].w));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: mat4 view() {  // offset 64
// CHECK-NEXT:     return mat4(Frame[4], Frame[5], Frame[6], Frame[7]);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec3_array4 bones(int i) {  // offset 128
// CHECK-NEXT:     return vec3_array4(vec3(Frame[3 * i + 8].x, Frame[3 * i + 9].x, Frame[3 * i + 10].x), vec3(Frame[3 * i + 8].y, Frame[3 * i + 9].y, Frame[3 * i + 10].y), vec3(Frame[3 * i + 8].z, Frame[3 * i + 9].z, Frame[3 * i + 10].z), vec3(Frame[3 * i + 8].w, Frame[3 * i + 9].w, Frame[3 * i + 10].w));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: Light light() {  // offset 320
// CHECK-NEXT:     return Light(Frame[20].xyz, float_array2(Frame[21].x, Frame[22].x));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 water() {  // offset 368
// CHECK-NEXT:     return Frame[23];
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec3 mul(vec4 a, vec3_array4 b) {
// CHECK-NEXT:     return a.x * b.e0 + a.y * b.e1 + a.z * b.e2 + a.w * b.e3;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float set_element(int i, float x, inout float_array3 a) {
// CHECK-NEXT:     if (i == 0) {
// CHECK-NEXT:         return a.e0 = x;
// CHECK-NEXT:     }
// CHECK-NEXT:     if (i == 1) {
// CHECK-NEXT:         return a.e1 = x;
// CHECK-NEXT:     }
// CHECK-NEXT:     return a.e2 = x;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float assign_add_element(int i, float x, inout float_array3 a) {
// CHECK-NEXT:     if (i == 0) {
// CHECK-NEXT:         return a.e0 += x;
// CHECK-NEXT:     }
// CHECK-NEXT:     if (i == 1) {
// CHECK-NEXT:         return a.e1 += x;
// CHECK-NEXT:     }
// CHECK-NEXT:     return a.e2 += x;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: mat3 truncate_mat3(mat4 m) {
// CHECK-NEXT:     return mat3(m[0].xyz, m[1].xyz, m[2].xyz);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: mat3 transpose_(mat3 m) {
// CHECK-NEXT:     return mat3(vec3(m[0].x, m[1].x, m[2].x), vec3(m[0].y, m[1].y, m[2].y), vec3(m[0].z, m[1].z, m[2].z));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec2 element(vec2_array3 a, int i) {
// CHECK-NEXT:     if (i == 0) {
// CHECK-NEXT:         return a.e0;
// CHECK-NEXT:     }
// CHECK-NEXT:     if (i == 1) {
// CHECK-NEXT:         return a.e1;
// CHECK-NEXT:     }
// CHECK-NEXT:     return a.e2;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: const vec2_array3 corners = vec2_array3(vec2(0.0), vec2(1.0, 0.0), vec2(0.0, 1.0));
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     vec3 skinned = vec3(0.0);
// CHECK-NEXT:     for (int i = 0; i < 4; i++) {
// CHECK-NEXT:         skinned += mul(in_POSITION0, bones(ivec4(in_BLENDINDICES0)[i])) * in_BLENDWEIGHT0[i];
// CHECK-NEXT:     }
// CHECK-NEXT:     float_array3 values;
// CHECK-NEXT:     int k;
// CHECK-NEXT:     for (int k_2 = 0; k_2 < 3; k_2++) {
// CHECK-NEXT:         if (!(k_2 < count)) {
// CHECK-NEXT:             break;
// CHECK-NEXT:         }
// CHECK-NEXT:         set_element(k_2, float(k_2), values);
// CHECK-NEXT:     }
// CHECK-NEXT:     assign_add_element(ivec4(in_BLENDINDICES0).x, light().weights.e1, values);
// CHECK-NEXT:     mat3 rotation = truncate_mat3(world());
// CHECK-NEXT:     vs_NORMAL0 = rotation * (transpose_(rotation) * in_NORMAL0) + values.e0 + element(corners, ivec4(in_BLENDINDICES0).y).xyx;
// CHECK-NEXT:     if (fog) {
// CHECK-NEXT:         vs_NORMAL0 *= light().color;
// CHECK-NEXT:     }
// CHECK-NEXT:     vec4 position = view() * (world() * vec4(skinned, 1.0));
// CHECK-NEXT:     position.z = dot(position, water());
// CHECK-NEXT:     gl_Position = position;
// CHECK-NEXT: }
