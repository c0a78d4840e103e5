// Reads of textures in a pixel shader: an image and a sampler are put together where they are used.
// RUN: %clipc -T ps_6_7 -spirv -S %s -o - | FileCheck %s
// RUN: %clipc -T ps_6_7 -spirv %s -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %draw compare %s -T ps_6_7 --target vulkan
Texture2D<float3> map : register(t0);
Texture2DArray layers[2] : register(t1);
Texture2DMS<float4> samples : register(t4);
Buffer<uint2> numbers : register(t5);
SamplerState linear_sampler : register(s0);
SamplerComparisonState depth_sampler : register(s1);
Texture2D<float> depth_map : register(t6);

// CHECK-DAG: OpCapability SampledBuffer
// CHECK-DAG: OpCapability ImageQuery
// CHECK:     OpExecutionMode %main OriginUpperLeft
// CHECK:     OpSampledImage
// CHECK:     OpImageSampleImplicitLod %v4float
// CHECK:     OpImageSampleImplicitLod %v4float {{.*}} Bias|ConstOffset
// CHECK:     OpImageSampleExplicitLod %v4float {{.*}} Grad
// CHECK:     OpImageSampleDrefExplicitLod %float {{.*}} Lod %float_0
// CHECK:     OpImageGather %v4float
// CHECK:     OpImageFetch %v4float {{.*}} Lod
// CHECK:     OpImageFetch %v4uint
// CHECK:     OpImageQuerySizeLod %v2int
float4 main(float4 p : SV_Position, float2 uv : TEXCOORD0) : SV_Target {
  float4 color = map.Sample(linear_sampler, uv).xyzz;
  color += layers[1].SampleBias(linear_sampler, float3(uv, 1), 0.5, int2(1, -1));
  color += map.SampleGrad(linear_sampler, uv, ddx(uv) * 2, ddy(uv)).xxyz;
  color.x += depth_map.SampleCmpLevelZero(depth_sampler, uv, 0.5);
  color += depth_map.GatherRed(linear_sampler, uv);
  color.xyz += map.Load(int3(1, 2, 0));
  color.xy += numbers[2] / 256.0;
  uint width, height;
  map.GetDimensions(width, height);
  return color + float2(width, height).xyxy / 64;
}
