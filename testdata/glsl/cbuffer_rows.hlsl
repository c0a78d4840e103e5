// What std140 would move is read out of an array of rows: scalars behind arrays, matrices and structs in their last row,
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
// CHECK-NEXT:     vec4 Floats_rows[23];
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 1) uniform Kinds {  // b1
// CHECK-NEXT:     uvec4 Kinds_rows[9];
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // POSITION0
// CHECK-NEXT: layout(location = 1) in uint in_INDEX0;  // INDEX0
// CHECK-EMPTY:
// CHECK-NEXT: float x() {  // offset 0
// CHECK-NEXT:     return Floats_rows[0].x;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec3 y() {  // offset 4
// CHECK-NEXT:     return Floats_rows[0].yzw;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float weights(int i_2) {  // offset 16
// CHECK-NEXT:     return Floats_rows[i_2 + 1].x;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float after_array() {  // offset 52
// CHECK-NEXT:     return Floats_rows[3].y;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: mat3 normal() {  // offset 64
// CHECK-NEXT:     return transpose(mat3(Floats_rows[4].xyz, Floats_rows[5].xyz, Floats_rows[6].xyz));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float after_matrix() {  // offset 108
// CHECK-NEXT:     return Floats_rows[6].w;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: mat4x3 frame() {  // offset 112
// CHECK-NEXT:     return mat4x3(Floats_rows[7].xyz, Floats_rows[8].xyz, Floats_rows[9].xyz, Floats_rows[10].xyz);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: mat4 bones(int i_2) {  // offset 176
// CHECK-NEXT:     return transpose(mat4(Floats_rows[4 * i_2 + 11], Floats_rows[4 * i_2 + 12], Floats_rows[4 * i_2 + 13], Floats_rows[4 * i_2 + 14]));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 across() {  // offset 304
// CHECK-NEXT:     return vec4(Floats_rows[19].x, Floats_rows[20].x, Floats_rows[21].x, Floats_rows[22].x);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: Mixed mixed() {  // offset 0
// CHECK-NEXT:     return Mixed(mat2(uintBitsToFloat(Kinds_rows[0].xy), uintBitsToFloat(Kinds_rows[1].xy)), transpose(mat2(uintBitsToFloat(Kinds_rows[2].xy), uintBitsToFloat(Kinds_rows[3].xy))), uintBitsToFloat(Kinds_rows[3].z));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float after_struct() {  // offset 60
// CHECK-NEXT:     return uintBitsToFloat(Kinds_rows[3].w);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: int i() {  // offset 64
// CHECK-NEXT:     return int(Kinds_rows[4].x);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: uvec2 u() {  // offset 68
// CHECK-NEXT:     return Kinds_rows[4].yz;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: bool b(int i_2) {  // offset 80
// CHECK-NEXT:     return Kinds_rows[i_2 + 5].x != 0u;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: bool after_bools() {  // offset 100
// CHECK-NEXT:     return Kinds_rows[6].y != 0u;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float f(int i_2) {  // offset 112
// CHECK-NEXT:     return uintBitsToFloat(Kinds_rows[i_2 + 7].x);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float[3] weights_all() {
// CHECK-NEXT:     float result[3];
// CHECK-NEXT:     for (int i_2 = 0; i_2 < 3; ++i_2) result[i_2] = weights(i_2);
// CHECK-NEXT:     return result;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     gl_Position = x() + y().xyzx + weights(int(in_INDEX0)) + weights(2) + after_array() + after_matrix();
// CHECK-NEXT:     gl_Position.xyz += normal() * in_POSITION0.xyz + normal()[1];
// CHECK-NEXT:     gl_Position.xyz += frame() * in_POSITION0;
// CHECK-NEXT:     gl_Position += bones(int(in_INDEX0)) * in_POSITION0 + across();
// CHECK-NEXT:     float all_[3] = weights_all();
// CHECK-NEXT:     gl_Position.x += all_[in_INDEX0];
// CHECK-NEXT:     gl_Position.xy += mixed().r[0] + mixed().c[1] + mixed().tail + after_struct();
// CHECK-NEXT:     gl_Position += vec4(uint(i()) + u().xyxy) + f(int(in_INDEX0));
// CHECK-NEXT:     if (b(int(in_INDEX0)) && after_bools()) {
// CHECK-NEXT:         gl_Position = vec4(0.0);
// CHECK-NEXT:     }
// CHECK-NEXT: }
