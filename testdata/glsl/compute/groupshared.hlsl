// Memory that a group shares, of every kind of type, and its atomic operations.
// RUN: %clipc %s -T cs_5_0 --validate -o - | FileCheck %s
// RUN: %clipc %s -T cs_5_0 --target=essl310 --validate -o - | FileCheck %s
// RUN: %clipc %s -T cs_6_0 --target=vulkan --validate -o - | FileCheck %s
// RUN: %clipc %s -T cs_5_1 -spirv -fspv-target-env=vulkan1.0 -o %t.spv && spirv-val --target-env vulkan1.0 %t.spv
// RUN: %clipc %s -T cs_6_0 -spirv -fspv-target-env=vulkan1.3 -o %t.spv && spirv-val --target-env vulkan1.3 %t.spv
struct Sample { float3 color; uint count; bool is_set; };
// CHECK: shared Sample samples[32];
groupshared Sample samples[32];
// CHECK: shared mat4 turns[2];
groupshared float4x4 turns[2];
// CHECK: shared bool is_done;
groupshared bool is_done;
// CHECK: shared float rows[4][8];
groupshared float rows[4][8];
// CHECK: shared int lowest;
groupshared int lowest;
// CHECK: shared uvec4 bits;
groupshared uint4 bits;
// CHECK-NOT: shared
groupshared float unused[8192];
RWStructuredBuffer<float4> result;

// CHECK: void add(uint index) {
void add(uint index) {
  uint before;
  // CHECK: before = atomicAdd(samples[index].count, 2u);
  InterlockedAdd(samples[index].count, 2, before);
  // CHECK: atomicMin(lowest, int(before) - 3);
  InterlockedMin(lowest, int(before) - 3);
  // CHECK: atomicMax(bits.y, before);
  InterlockedMax(bits.y, before);
  // CHECK: atomicOr(bits[index & 3u], 1u);
  InterlockedOr(bits[index & 3], 1);
  InterlockedAnd(bits.z, ~before);
  InterlockedXor(bits.w, before);
  // CHECK: before = atomicExchange(bits.x, 7u);
  InterlockedExchange(bits.x, 7, before);
  // CHECK: before = atomicCompSwap(bits.x, 7u, index);
  InterlockedCompareExchange(bits.x, 7, index, before);
  // CHECK: atomicCompSwap(lowest, 0, 1);
  InterlockedCompareStore(lowest, 0, 1);
  int old;
  // CHECK: old = int(atomicAdd(bits.y, 1u));
  InterlockedAdd(bits.y, 1, old);
}

[numthreads(32, 1, 1)]
void main(uint index : SV_GroupIndex) {
  samples[index] = (Sample)0;
  samples[index].color.zx = float2(index, 1);
  if (index == 0) {
    turns[0] = float4x4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
    turns[1][2] = 5;
    is_done = false;
    lowest = 0;
    bits = 0;
  }
  rows[index / 8][index % 8] = index;
  GroupMemoryBarrierWithGroupSync();
  add(index);
  if (index == 31) is_done = true;
  GroupMemoryBarrierWithGroupSync();
  result[index] = mul(float4(samples[31 - index].color, rows[3][index % 8]), turns[0]) + lowest + (is_done ? bits : 0);
}
