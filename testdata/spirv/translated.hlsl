// The writer makes SPIR-V for Vulkan, structured buffers of words where no block has their elements at Direct3D's places; SPIR-V of
// an older GLSL is glslang's.
// RUN: %clipc -T ps_5_0 -spirv -S %s -o - | FileCheck %s --check-prefix=WRITTEN
// RUN: %clipc -T ps_5_0 -E plain -spirv -S %s -o - | FileCheck %s --check-prefix=WRITTEN
// RUN: %clipc -T ps_5_0 -E plain -spirv --target=glsl330 -S %s -o - | FileCheck %s --check-prefix=TRANSLATED
// TRANSLATED: OpSource GLSL {{[34]}}{{[356]}}0
// WRITTEN: OpSource HLSL 500
StructuredBuffer<float3> points : register(t1);

float4 main(float4 p : SV_Position) : SV_Target { return p + points[2].xyzx; }

float4 plain(float4 p : SV_Position) : SV_Target { return p.wzyx; }
