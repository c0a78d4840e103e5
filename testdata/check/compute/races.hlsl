// Waits in flow that shared memory decides, which another thread may change before all have read it. fxc X4026 ("due to a potential race
// condition this sync is illegal, consider adding a sync after reading any values controlling shader execution at this point").
// RUN: %clipc %s -T cs_5_0 -fsyntax-only 2>&1 | FileCheck %s --implicit-check-not=warning:
groupshared uint left;
RWBuffer<uint> o;
void Step(uint i) {
  GroupMemoryBarrierWithGroupSync();
  if (i == 0) left--;
}
[numthreads(64, 1, 1)] void main(uint i : SV_GroupIndex) {
  if (i == 0) left = 8;
  // CHECK: [[#@LINE+1]]:17: warning: `GroupMemoryBarrierWithGroupSync` waits for the group in flow that `left` decides, which another thread may change before all have read it; read it into a variable, and wait once more before that decides; fxc reports an error [-Wwait-may-race]
  if (left > 3) GroupMemoryBarrierWithGroupSync();
  GroupMemoryBarrierWithGroupSync();
  // All have read it before one writes it, and wait before they read it again.
  while (left > 4) {
    GroupMemoryBarrierWithGroupSync();
    if (i == 0) left--;
    GroupMemoryBarrierWithGroupSync();
  }
  for (uint k = 0; k < left; k++) GroupMemoryBarrierWithGroupSync();
  // CHECK: [[#@LINE+3]]:5: warning: `GroupMemoryBarrierWithGroupSync` waits for the group in flow that `left` decides
  while (left > 2) {
    if (i == 0) left--;
    GroupMemoryBarrierWithGroupSync();
  }
  // CHECK: [[#@LINE+2]]:5: warning: `AllMemoryBarrierWithGroupSync` waits for the group in flow that `o` decides
  do {
    AllMemoryBarrierWithGroupSync();
    if (i == 0) o[0] += 1;
  } while (o[0] < 5);
  Step(i);
  GroupMemoryBarrierWithGroupSync();
  const uint kept = left;
  GroupMemoryBarrierWithGroupSync();
  if (kept > 1) GroupMemoryBarrierWithGroupSync();
}
