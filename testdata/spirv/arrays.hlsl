// Arrays of objects: an index that varies, one that differs between invocations, an array of any number of objects.
// RUN: %clipc -T ps_6_0 -spirv -S %s -o - | FileCheck %s
// RUN: %clipc -T ps_6_0 -spirv %s -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %clipc -T ps_6_0 -spirv -fspv-target-env=vulkan1.0 %s -o %t.spv && spirv-val --target-env vulkan1.0 %t.spv
// RUN: %clipc -T ps_6_0 -spirv -fspv-target-env=vulkan1.2 -S %s -o - | FileCheck %s --check-prefix=NEW
// RUN: %clipc -T ps_6_0 -spirv -fspv-target-env=vulkan1.2 %s -o %t.spv && spirv-val --target-env vulkan1.2 %t.spv
// RUN: %clipc -T ps_6_0 -E any -spirv -S %s -o - | FileCheck %s --check-prefix=ANY
// RUN: %clipc -T ps_6_0 -E any -spirv %s -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %draw compare %s -T ps_6_0 --target vulkan --ints 0..3
Texture2D<float4> maps[4] : register(t0);
SamplerState samplers[2] : register(s0);
RWTexture2D<uint> counts[4] : register(u0);
StructuredBuffer<float4> lists[4] : register(t4);
Buffer<float4> colors[4] : register(t8);
Texture2D<float4> all_maps[] : register(t0, space1);

// CHECK-DAG: OpCapability ShaderNonUniform
// CHECK-DAG: OpCapability SampledImageArrayNonUniformIndexing
// CHECK-DAG: OpCapability StorageImageArrayNonUniformIndexing
// CHECK-DAG: OpCapability StorageBufferArrayNonUniformIndexing
// CHECK-DAG: OpExtension "SPV_EXT_descriptor_indexing"
// CHECK-DAG: OpDecorate {{%[0-9]+}} NonUniform
// CHECK:     [[POINTER:%[0-9]+]] = OpAccessChain {{.*}} %maps
// CHECK-NEXT: OpLoad {{.*}} [[POINTER]]
// NEW-NOT: OpExtension
float4 main(float4 p : SV_Position, nointerpolation uint i : I, nointerpolation uint k : K) : SV_Target {
  const uint at = NonUniformResourceIndex(i & 3);
  const uint2 place = uint2(p.xy) % 16;
  uint old, width, height, count, stride;
  float4 sum = maps[at].SampleLevel(samplers[k & 1], p.xy / 64, 0);
  InterlockedAdd(counts[NonUniformResourceIndex(k & 3)][place], 2, old);
  counts[NonUniformResourceIndex(i & 3)][place] = 4;
  sum += lists[NonUniformResourceIndex(k & 3)][place.x] + colors[k & 3][place.y];
  maps[NonUniformResourceIndex(k & 3)].GetDimensions(width, height);
  lists[NonUniformResourceIndex(i & 3)].GetDimensions(count, stride);
  return sum + width + height * 2 + count + stride;
}

// ANY: OpCapability RuntimeDescriptorArray
// ANY: OpTypeRuntimeArray
float4 any(nointerpolation uint i : I) : SV_Target { return all_maps[NonUniformResourceIndex(i)].Load(0); }
