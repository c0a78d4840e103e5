// SPIR-V as text is in the form of spirv-dis, and spirv-as reads it.
// RUN: %clipc -T vs_5_0 -spirv %s -o %t.spv
// RUN: %clipc -T vs_5_0 -spirv -S %s -o %t.spvasm
// RUN: spirv-dis %t.spv -o %t.listed
// RUN: diff %t.listed %t.spvasm
// RUN: spirv-as --target-env spv1.3 --preserve-numeric-ids %t.spvasm -o %t.again
// RUN: spirv-dis --no-header %t.spv -o %t.first && spirv-dis --no-header %t.again -o %t.second && diff %t.first %t.second
// RUN: FileCheck %s --input-file %t.spvasm
// CHECK: OpCapability ClipDistance
// CHECK: OpEntryPoint Vertex %main "main"
float4x4 world;
float4 plane;
[clipplanes(plane)]
float4 main(float4 p : POSITION) : SV_Position { return mul(p, world); }
