// How matrices lie in structured buffers: the qualifier of the template argument counts first, then
// the one of a typedef, the pragma, and the option. Source: DXC's pragma.pack_matrix.hlsl and
// type.matrix.majorness.zpr.hlsl. GLSL's row_major is HLSL's column_major.
// RUN: %draw compare %s -T vs_5_0 --target vulkan,glsl450,essl310 --lower none --ints 0..3
// RUN: %draw compare %s -T vs_5_0 --row-major --target vulkan,glsl450,essl310 --lower none --ints 0..3
// RUN: %clipc -T vs_5_0 %s -o - | FileCheck %s --check-prefixes=CHECK,COLUMNS
// RUN: %clipc -T vs_5_0 -Zpr %s -o - | FileCheck %s --check-prefixes=CHECK,ROWS
// COLUMNS: layout(std430, binding = 0, row_major) readonly buffer plain_block
// ROWS: layout(std430, binding = 0) readonly buffer plain_block
StructuredBuffer<float4x4> plain : register(t0);
// CHECK: layout(std430, binding = 1) readonly buffer by_row_block
StructuredBuffer<row_major float4x4> by_row : register(t1);
// CHECK: layout(std430, binding = 2, row_major) readonly buffer by_column_block
StructuredBuffer<column_major float4x4> by_column : register(t2);
typedef row_major float4x4 Rows;
// CHECK: layout(std430, binding = 3) readonly buffer named_block
StructuredBuffer<Rows> named : register(t3);
// CHECK: layout(std430, binding = 4, row_major) readonly buffer over_named_block
StructuredBuffer<column_major Rows> over_named : register(t4);
typedef StructuredBuffer<row_major float4x4> Buffers;
// CHECK: layout(std430, binding = 5) readonly buffer whole_block
Buffers whole : register(t5);
struct Held {
  StructuredBuffer<row_major float4x4> rows;
  StructuredBuffer<float4x4> plain;
};
Held held;
#pragma pack_matrix(row_major)
// CHECK: layout(std430, binding = 6) readonly buffer pragma_block
StructuredBuffer<float4x4> pragma_ : register(t6);
// CHECK: layout(std430, binding = 7) readonly buffer narrow_block
StructuredBuffer<float2x3> narrow : register(t7);
// CHECK: layout(std430, binding = 8) readonly buffer held_rows_block
// COLUMNS: layout(std430, binding = 9, row_major) readonly buffer held_plain_block
// ROWS: layout(std430, binding = 9) readonly buffer held_plain_block

float4 main(float4 p : POSITION, int i : INDEX) : SV_Position {
  float4 sum = mul(p, plain[i]) + mul(p, by_row[i]) + mul(p, by_column[i]) + mul(p, named[i]);
  sum += mul(p, over_named[i]) + mul(p, whole[i]) + mul(p, pragma_[i]);
  sum += mul(p, held.rows[i]) + mul(p, held.plain[i]);
  sum.xyz += mul(p.xy, narrow[i]);
  return sum;
}
