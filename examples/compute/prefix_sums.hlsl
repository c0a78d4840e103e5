// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Prefix sums of a group: thread i has counts[i] items to store, and learns where its items begin.
// clipc -T cs_5_0
static const uint kThreads = 64;

StructuredBuffer<uint> counts : register(t0);  // kThreads for each group
RWStructuredBuffer<uint> offsets : register(u0);
RWStructuredBuffer<uint> totals : register(u1);  // one for each group

groupshared uint sums[kThreads];

[numthreads(kThreads, 1, 1)]
void main(uint id : SV_DispatchThreadID, uint group : SV_GroupID, uint index : SV_GroupIndex) {
  const uint own = counts[id];
  sums[index] = own;
  GroupMemoryBarrierWithGroupSync();

  // sums[i] is the sum of the `reach` counts up to counts[i]. Each iteration doubles the reach.
  for (uint reach = 1; reach < kThreads; reach *= 2) {
    uint before = 0;
    if (index >= reach) before = sums[index - reach];
    // All threads have read the old sums before a thread stores a new one,
    GroupMemoryBarrierWithGroupSync();
    sums[index] += before;
    // and all new sums are stored before a thread reads one.
    GroupMemoryBarrierWithGroupSync();
  }

  // The sum has the thread's own count in it, and the offset does not.
  offsets[id] = sums[index] - own;
  if (index == kThreads - 1) totals[group] = sums[index];
}
