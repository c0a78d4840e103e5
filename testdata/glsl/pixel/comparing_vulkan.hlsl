// On Vulkan the comparisons that GLSL has no function for are SPIR-V's own instructions: glslang 12 does not know
// GL_EXT_texture_shadow_lod.
// RUN: %clipc -T ps_6_8 %s --target=vulkan --validate --verify -o - | FileCheck %s
// RUN: %clipc -T ps_6_8 %s -spirv -o %t.spv
// RUN: %clipc -T ps_5_0 -E zero %s -spirv -S -o - | FileCheck %s --check-prefix=ZERO
// RUN: %draw compare %s -T ps_5_0 -E zero --target=vulkan
// CHECK: #extension GL_EXT_spirv_intrinsics : require
// CHECK-DAG: spirv_instruction(id = 90) float sample_compare_level(samplerCubeArrayShadow sampled, vec4 place, float reference, spirv_literal int operands, float level);
// CHECK-DAG: spirv_instruction(id = 90) float sample_compare_level(sampler2DArrayShadow sampled, vec3 place, float reference, spirv_literal int operands, float level, ivec2 offset);
// CHECK-DAG: spirv_instruction(id = 90) float sample_compare_level(samplerCubeArrayShadow sampled, vec4 place, float reference, spirv_literal int operands, vec3 d1, vec3 d2);
// CHECK-DAG: spirv_instruction(id = 89) float sample_compare_bias(sampler2DArrayShadow sampled, vec3 place, float reference, spirv_literal int operands, float level);
Texture2DArray layers;
TextureCube sky;
TextureCubeArray skies;
SamplerComparisonState compares;
float4 zero(float4 p : P) : SV_Target {
  // ZERO: OpImageSampleDrefExplicitLod
  return skies.SampleCmpLevelZero(compares, p, 0.5);
}
float4 main(float4 p : P) : SV_Target {
  float4 r = zero(p);
  r += layers.SampleCmpLevel(compares, p.xyz, p.w, 1);
  r += layers.SampleCmpLevel(compares, p.xyz, p.w, 1, int2(1, -1));
  r += sky.SampleCmpLevel(compares, p.xyz, p.w, 2);
  r += layers.SampleCmpBias(compares, p.xyz, p.w, 0.5);
  r += skies.SampleCmpBias(compares, p, 0.5, 1);
  return r + skies.SampleCmpGrad(compares, p, 0.5, p.xyz, p.yzx);
}
