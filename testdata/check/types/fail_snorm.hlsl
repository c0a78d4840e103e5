// `snorm` and `unorm` are for floating-point types (fxc X3085; DXC's scalar-assignments.hlsl), and
// `row_major` for matrices (X3077; DXC's typemods-syntax.hlsl).
// RUN: not %clipc -T vs_5_0 %s 2>&1 | grep -v '^ ' | FileCheck %s
// CHECK-DAG: [[#@LINE+1]]:12: error: `snorm` is for floating-point types; `bool` is not one [qualifier-needs-float, X3085]
snorm bool whether;
// CHECK-DAG: [[#@LINE+1]]:24: error: `unorm` is for floating-point types; `uint2` is not one
struct S { unorm uint2 n; snorm float2x2 good; };
S s;
// CHECK-DAG: [[#@LINE+1]]:18: warning: `row_major` has no effect on `float4`, which is not a matrix [-Wqualifier-without-effect]
row_major float4 rows;
// CHECK-DAG: [[#@LINE+1]]:38: warning: `row_major` has no effect on `StructuredBuffer<float4x4>`, which is not a matrix
row_major StructuredBuffer<float4x4> turned;
unorm float3 color;
float4 main(float4 p : POSITION) : SV_Position { return rows * p * whether + s.n.x + color.x + turned[0][0] + s.good[0].x; }
