// Buffers without a register: $Globals, then $Params, then the others in order. Oracle: vkd3d's hlsl_d3d12.c, test_reflection, whose
// bindings are Direct3D's compiler's.
// RUN: %clipc -T vs_5_0 %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 %s -E alone -o - | FileCheck %s --check-prefix=ALONE
cbuffer b1 { float4 a; };
cbuffer b5 : register(b5) { float4 u; };
float4 m;
// CHECK: uniform Globals {  // b0
// CHECK: uniform b1 {  // b2
// CHECK: uniform b5 {  // b5
// CHECK: uniform Params {  // b1
float4 main(uniform float4 n) : SV_Position { return a + m + n + u; }
// ALONE: uniform b1 {  // b1
// ALONE: uniform Params {  // b0
float4 alone(uniform float4 n) : SV_Position { return a + n; }
