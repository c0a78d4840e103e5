// Floats are exchanged, and compared by their bits: those that a group shares and those of buffers are words for it.
// RUN: %clipc %s -T cs_6_0 --validate -o - | FileCheck %s
// RUN: %clipc %s -T cs_6_0 -spirv -o %t.spv
// RUN: %draw compare %s -T cs_6_0
// RUN: %draw compare %s -T cs_6_0 --seed 2 --quarters --exact
// CHECK-DAG: shared uint sums[8];
// CHECK-DAG: shared uint grid[2][3];
struct Cell { float3 a; float weight; int count; float more[2]; };
RWStructuredBuffer<Cell> cells;
RWStructuredBuffer<float> floats;
RWByteAddressBuffer bytes;
RWStructuredBuffer<float4> result;
groupshared float sums[8];
groupshared float grid[2][3];

[numthreads(8, 1, 1)]
void main(uint3 id : SV_DispatchThreadID, uint i : SV_GroupIndex) {
  uint slot = id.x + 24 * id.y;
  float4 old = 0;
  int whole;
  // CHECK: sums[{{.*}}] = floatBitsToUint(
  float first = sums[i] = slot * 0.5;
  if (i < 6) grid[i % 2][i / 2] = i;
  GroupMemoryBarrierWithGroupSync();
  if (i == 0) {
    // CHECK: uintBitsToFloat(atomicExchange(sums[1], floatBitsToUint(
    InterlockedExchange(sums[1], 2.5, old.x);
    InterlockedExchange(sums[1], sums[2] - 1, whole);
    // CHECK: atomicCompSwap(grid[1][2], floatBitsToUint(5.0), floatBitsToUint(
    InterlockedCompareStoreFloatBitwise(grid[1][2], 5, -old.x);
    InterlockedCompareExchangeFloatBitwise(grid[0][0], 0, 9, old.y);
    old.z = whole;
  }
  GroupMemoryBarrierWithGroupSync();
  old += float4(sums[1], grid[1][2], grid[0][0], first);
  // CHECK: uintBitsToFloat(atomicExchange(cells[
  InterlockedExchange(cells[slot].weight, 3, old.w);
  InterlockedCompareExchangeFloatBitwise(cells[slot].more[i & 1], cells[slot].more[i & 1], 8, whole);
  // CHECK: {{^ *}}atomicAdd(cells[
  InterlockedAdd(cells[slot].count, 5);
  // CHECK: {{^ *}}atomicCompSwap(floats[
  InterlockedCompareStoreFloatBitwise(floats[slot], floats[slot], old.w);
  cells[slot].a.x = whole;
  float given;
  bytes.InterlockedExchangeFloat(4 * slot, 2.25, given);
  bytes.InterlockedCompareStoreFloatBitwise(4 * slot, 2.25, -1);
  bytes.InterlockedCompareExchangeFloatBitwise(4 * slot, -1, 6, given);
  result[slot] = old + given;
}
