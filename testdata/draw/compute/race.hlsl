// Threads that race for the memory that they share: such a program means nothing, which is said instead of a comparison.
// RUN: not %draw compare %s -T cs_5_0 -E late 2>&1 | FileCheck %s
// RUN: not %draw compare %s -T cs_5_0 -E mixed 2>&1 | FileCheck %s
// RUN: not %draw compare %s -T cs_5_0 -E objects_only 2>&1 | FileCheck %s
// RUN: not %draw compare %s -T cs_6_0 -E some 2>&1 | FileCheck %s --check-prefix=SOME
// RUN: %draw compare %s -T cs_5_0 -E right
// CHECK: threads of a group race for the memory that they share
// SOME: some threads of a group wait where others do not
RWStructuredBuffer<uint> result;
groupshared uint memory[8];
[numthreads(8, 1, 1)] void late(uint i : SV_GroupIndex) {
  memory[i] = i;
  result[i] = memory[7 - i];
}
[numthreads(8, 1, 1)] void mixed(uint i : SV_GroupIndex) {
  if (i == 3) memory[0] = 1;
  InterlockedAdd(memory[0], 1);
}
// The barrier waits, and orders what is stored in objects only.
[numthreads(8, 1, 1)] void objects_only(uint i : SV_GroupIndex) {
  memory[i] = i;
  DeviceMemoryBarrierWithGroupSync();
  result[i] = memory[7 - i];
}
[numthreads(8, 1, 1)] void some(uint i : SV_GroupIndex) {
  memory[i] = i;
  if (i < 4) GroupMemoryBarrierWithGroupSync();
  result[i] = memory[i];
}
[numthreads(8, 1, 1)] void right(uint i : SV_GroupIndex) {
  memory[i] = i;
  GroupMemoryBarrierWithGroupSync();
  result[i] = memory[7 - i];
}
