// What the writer of SPIR-V lacks, glslang translates from the GLSL: structured buffers whose elements no block has at their places,
// OpenGL's SPIR-V.
// RUN: %clipc -T ps_5_0 -spirv -S %s -o - | FileCheck %s --check-prefix=TRANSLATED
// RUN: %clipc -T ps_5_0 -E plain -spirv -S %s -o - | FileCheck %s --check-prefix=WRITTEN
// RUN: %clipc -T ps_5_0 -E plain -spirv --target=glsl450 -S %s -o - | FileCheck %s --check-prefix=TRANSLATED
// TRANSLATED: OpSource GLSL 4{{[56]}}0
// WRITTEN: OpSource HLSL 500
StructuredBuffer<float3> points : register(t1);

float4 main(float4 p : SV_Position) : SV_Target { return p + points[2].xyzx; }

float4 plain(float4 p : SV_Position) : SV_Target { return p.wzyx; }
