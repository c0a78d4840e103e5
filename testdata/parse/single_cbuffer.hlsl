// `single` is a qualifier of a cbuffer and an ordinary name elsewhere. Oracle: vkd3d's cbuffer.shader_test, lines 50 and 67, checked
// against fxc.
// RUN: %clipc -T vs_5_0 %s --dump=ir | FileCheck %s
// CHECK: cbuffer First : b0
// CHECK: float4 single
// CHECK: cbuffer Second : b1
cbuffer First { float4 single; };
single cbuffer Second { float4 other; };
float4 main(float4 p : POSITION) : SV_Position { return p * single + other; }
