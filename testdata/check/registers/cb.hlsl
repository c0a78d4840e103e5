// fxc takes `cb1` for `b1`: Intel's samples for Direct3D 11 and other public programs write it so.
// RUN: %clipc -T vs_5_0 %s | FileCheck %s
cbuffer Frame : register(cb1) { float4 a; }
cbuffer Object : register(vs_5_0, CB3) { float4 b; }
// CHECK: layout(std140, binding = 1) uniform Frame
// CHECK: layout(std140, binding = 3) uniform Object
float4 main(float4 p : POSITION) : SV_Position { return p * a + b; }
