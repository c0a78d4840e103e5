// What std140 would move is read by hand: scalars after arrays, matrices and structs in their last row,
// vectors that std140 would align, matrices whose registers hold one component, structs that mix row_major and column_major.
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=glsl150 --validate %s -o %t
// RUN: %clipc -T vs_5_0 --target=essl300 --validate %s -o %t
// RUN: %clipc -T vs_5_0 --target=vulkan --validate %s -o %t
// AUTOUPDATE
cbuffer Floats {
  float x;
  float3 y;
  float weights[3];
  float after_array;
  float3x3 normal;
  float after_matrix;
  row_major float4x3 frame;
  float4x4 bones[2];
  float1x4 across;
};
struct Mixed {
  row_major float2x2 r;
  float2x2 c;
  float tail;
};
cbuffer Kinds {
  Mixed mixed;
  float after_struct;
  int i;
  uint2 u;
  bool b[2];
  bool after_bools;
  float f[2];
};

float4 main(float4 p : POSITION, uint n : INDEX) : SV_Position {
  float4 r = x + y.xyzx + weights[n] + weights[2] + after_array + after_matrix;
  r.xyz += mul(p.xyz, normal) + normal[1];
  r.xyz += mul(p, frame);
  r += mul(p, bones[n]) + across;
  float all[3] = weights;
  r.x += all[n];
  r.xy += mixed.r[0] + mixed.c[1] + mixed.tail + after_struct;
  r += i + u.xyxy + f[n];
  if (b[n] && after_bools) r = 0;
  return r;
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: struct Mixed {
// CHECK-NEXT:     mat2 r;
// CHECK-NEXT:     mat2 c;
// CHECK-NEXT:     float tail;
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 0) uniform Floats {  // b0
// CHECK-NEXT:     float x;
// CHECK-NEXT:     float y_x;
// CHECK-NEXT:     float y_y;
// CHECK-NEXT:     float y_z;
// CHECK-NEXT:     vec4 weights_rows[3];
// CHECK-NEXT:     vec4 normal_rows[3];
// CHECK-NEXT:     mat4x3 frame;
// CHECK-NEXT:     layout(row_major) mat4 bones[2];
// CHECK-NEXT:     vec4 across_rows[4];
// CHECK-NEXT: } floats;
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 1) uniform Kinds {  // b1
// CHECK-NEXT:     vec4 mixed_rows[4];
// CHECK-NEXT:     int i;
// CHECK-NEXT:     uint u_x;
// CHECK-NEXT:     uint u_y;
// CHECK-NEXT:     uvec4 b_rows[2];
// CHECK-NEXT:     float f[2];
// CHECK-NEXT: } kinds;
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-NEXT: layout(location = 1) in uint in_INDEX0;  // n : INDEX0
// CHECK-EMPTY:
// CHECK-NEXT: vec3 y() {  // offset 4
// CHECK-NEXT:     return vec3(floats.y_x, floats.y_y, floats.y_z);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float weights(int i) {  // offset 16
// CHECK-NEXT:     return floats.weights_rows[i].x;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float after_array() {  // offset 52
// CHECK-NEXT:     return floats.weights_rows[2].y;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: mat3 normal() {  // offset 64
// CHECK-NEXT:     return transpose(mat3(floats.normal_rows[0].xyz, floats.normal_rows[1].xyz, floats.normal_rows[2].xyz));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float after_matrix() {  // offset 108
// CHECK-NEXT:     return floats.normal_rows[2].w;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 across() {  // offset 304
// CHECK-NEXT:     return vec4(floats.across_rows[0].x, floats.across_rows[1].x, floats.across_rows[2].x, floats.across_rows[3].x);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: Mixed mixed() {  // offset 0
// CHECK-NEXT:     return Mixed(mat2(kinds.mixed_rows[0].xy, kinds.mixed_rows[1].xy), transpose(mat2(kinds.mixed_rows[2].xy, kinds.mixed_rows[3].xy)), kinds.mixed_rows[3].z);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float after_struct() {  // offset 60
// CHECK-NEXT:     return kinds.mixed_rows[3].w;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: uvec2 u() {  // offset 68
// CHECK-NEXT:     return uvec2(kinds.u_x, kinds.u_y);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: bool b(int i) {  // offset 80
// CHECK-NEXT:     return kinds.b_rows[i].x != 0u;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: bool after_bools() {  // offset 100
// CHECK-NEXT:     return kinds.b_rows[1].y != 0u;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float[3] weights_all() {
// CHECK-NEXT:     float result[3];
// CHECK-NEXT:     for (int i = 0; i < 3; ++i) {
// CHECK-NEXT:         result[i] = weights(i);
// CHECK-NEXT:     }
// CHECK-NEXT:     return result;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     gl_Position = floats.x + y().xyzx + weights(int(in_INDEX0)) + weights(2) + after_array() + after_matrix();
// CHECK-NEXT:     gl_Position.xyz += normal() * in_POSITION0.xyz + normal()[1];
// CHECK-NEXT:     gl_Position.xyz += floats.frame * in_POSITION0;
// CHECK-NEXT:     gl_Position += floats.bones[in_INDEX0] * in_POSITION0 + across();
// CHECK-NEXT:     float all_[3] = weights_all();
// CHECK-NEXT:     gl_Position.x += all_[in_INDEX0];
// CHECK-NEXT:     gl_Position.xy += mixed().r[0] + mixed().c[1] + mixed().tail + after_struct();
// CHECK-NEXT:     gl_Position += vec4(uint(kinds.i) + u().xyxy) + kinds.f[in_INDEX0];
// CHECK-NEXT:     if (b(int(in_INDEX0)) && after_bools()) {
// CHECK-NEXT:         gl_Position = vec4(0.0);
// CHECK-NEXT:     }
// CHECK-NEXT: }
