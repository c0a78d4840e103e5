// Where all threads of a group come to a barrier, and where not. fxc X3663; dxc says nothing.
// RUN: not %clipc %s -T cs_5_0 -fsyntax-only 2>&1 | FileCheck %s --check-prefixes=CHECK,OLD -DKIND=error
// RUN: %clipc %s -T cs_6_0 -fsyntax-only 2>&1 | FileCheck %s --check-prefixes=CHECK,NEW -DKIND=warning
// RUN: %clipc %s -T cs_5_0 -D ALONE -fsyntax-only 2>&1 | count 0
#ifdef ALONE
#define THREADS 1
#else
#define THREADS 64
#endif
uint count;
groupshared uint memory[64];
groupshared uint length;
RWStructuredBuffer<uint> result;

void wait(uint i) {
  // Called in varying flow once.
  // CHECK: [[#@LINE+3]]:3: [[KIND]]: `AllMemoryBarrierWithGroupSync` waits for the group in flow that some of its threads may not come to
  // OLD-SAME: ; move it to where all of them run it [wait-in-varying-flow, X3663]
  // NEW-SAME: , where GLSL leaves the result undefined; fxc reports an error [-Wwait-may-hang]
  AllMemoryBarrierWithGroupSync();
  memory[i] = 1;
}

[numthreads(THREADS, 1, 1)]
void main(uint i : SV_GroupIndex, uint3 group : SV_GroupID) {
  memory[i] = i;
  // CHECK-NOT: {{error|warning}}
  GroupMemoryBarrierWithGroupSync();
  // The group, a constant and what the group shares are the same for all.
  if (group.x > 3 && count > 2) GroupMemoryBarrierWithGroupSync();
  for (uint s = 32; s > 0; s >>= 1) {
    if (i < s) memory[i] += memory[i + s];
    GroupMemoryBarrierWithGroupSync();
  }
  if (i == 0) length = memory[0];
  GroupMemoryBarrierWithGroupSync();
  for (uint k = 0; k < length; ++k) GroupMemoryBarrierWithGroupSync();
  if (memory[0] > 5) GroupMemoryBarrierWithGroupSync();
  // CHECK: [[#@LINE+1]]:22: [[KIND]]: `GroupMemoryBarrierWithGroupSync` waits
  if (memory[i] > 5) GroupMemoryBarrierWithGroupSync();
  // CHECK: [[#@LINE+1]]:32: [[KIND]]: `GroupMemoryBarrierWithGroupSync` waits
  for (uint n = 0; n < i; ++n) GroupMemoryBarrierWithGroupSync();
  if (i < 4) {
    GroupMemoryBarrier();
    wait(i);
  }
  uint old;
  InterlockedAdd(memory[0], 1, old);
  // CHECK: [[#@LINE+1]]:17: [[KIND]]: `GroupMemoryBarrierWithGroupSync` waits
  if (old == 7) GroupMemoryBarrierWithGroupSync();
  if (i == 9) return;
  // CHECK: [[#@LINE+1]]:3: [[KIND]]: `DeviceMemoryBarrierWithGroupSync` waits
  DeviceMemoryBarrierWithGroupSync();
  result[i] = memory[i];
}
