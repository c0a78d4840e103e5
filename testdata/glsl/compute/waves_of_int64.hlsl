// The functions of waves take 64-bit integers by an extension of their own.
// RUN: %clipc -T cs_6_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T cs_6_0 --validate --target=vulkan %s -o - | FileCheck %s
// CHECK: #extension GL_EXT_shader_subgroup_extended_types_int64 : require
RWStructuredBuffer<int64_t> results : register(u0);

[numthreads(64, 1, 1)]
void main(uint3 id : SV_DispatchThreadID) {
  int64_t value = id.x;
  // CHECK: subgroupMax(value)
  results[id.x] = WaveActiveMax(value) + WavePrefixSum(value) + QuadReadAcrossX(value);
}
