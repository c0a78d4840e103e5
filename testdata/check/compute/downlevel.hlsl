// What Direct3D 10 hardware does not do ("Compute Shaders on Downlevel Hardware"): GLSL does it all, so clipc warns.
// RUN: %clipc %s -T cs_4_0 -fsyntax-only 2>&1 | FileCheck %s --implicit-check-not=warning
// RUN: %clipc %s -T cs_5_0 -fsyntax-only 2>&1 | count 0
RWStructuredBuffer<float4> first;
// CHECK: [[#@LINE+1]]:28: warning: `second` is another buffer that the shader writes; `cs_4_0` has one, and fxc reports an error [-Wsecond-writable-buffer]
RWStructuredBuffer<float4> second;
struct Cell { float4 a; float b[2]; };
groupshared Cell cells[8];
groupshared float sum;
groupshared float table[8][4];

[numthreads(8, 1, 1)]
void main(uint i : SV_GroupIndex, uint3 id : SV_GroupThreadID) {
  cells[i].a = 1;
  cells[id.x].b[1] = 2;
  table[i][3 - 1] = 0;
  // CHECK: [[#@LINE+1]]:3: warning: `cells` is written at a place that is not the thread's own; `cs_4_0` writes an array at SV_GroupIndex or SV_GroupThreadID alone, and fxc reports an error [-Wshared-write-at-other]
  cells[7 - i].a = 3;
  // CHECK: [[#@LINE+1]]:15: warning: `sum` is written
  if (i == 0) sum = 4;
  // CHECK: [[#@LINE+1]]:3: warning: `table` is written
  table[0][i] = 5;
  GroupMemoryBarrierWithGroupSync();
  first[i] = cells[7 - i].a + sum + table[i][1];
  second[i] = 0;
}
