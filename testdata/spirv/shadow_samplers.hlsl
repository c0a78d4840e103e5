// Direct3D 9's samplers that compare: the third coordinate is the reference. A constant of 64 bits that may be specialised.
// RUN: %clipc -T ps_3_0 --shadow-samplers map -spirv -S %s -o - | FileCheck %s
// RUN: %clipc -T ps_3_0 --shadow-samplers map -spirv %s -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %clipc -T ps_3_0 --shadow-samplers map -G %s -o %t.spv && spirv-val --target-env opengl4.5 %t.spv
// RUN: %draw compare %s -T ps_3_0 --shadow-samplers map --target vulkan,glsl450
// RUN: %clipc -T ps_6_0 -E wide -spirv -S %s -o - | FileCheck %s --check-prefix=WIDE
sampler2D map;
// CHECK: OpSource HLSL 300
// CHECK: OpImageSampleDrefExplicitLod %float
// CHECK: OpFDiv %v3float
// CHECK: OpImageSampleDrefImplicitLod %float
float4 main(float4 p : TEXCOORD0) : COLOR0 { return tex2Dlod(map, float4(p.xy, 0.25, 1)) + tex2Dproj(map, float4(p.xy, 0.5, 2)); }

// WIDE: OpSpecConstant %double 0.5
[[vk::constant_id(3)]] const double factor = 0.5;
float4 wide(float4 p : P) : SV_Target { return p * (float)factor; }
