// What is not done to floats that atomic operations change: dxc asks the first argument's type alone (its test
// atomic-float-errors), and GLSL has these operations of integers only.
// RUN: not %clipc -T cs_6_6 %s -o %t 2>&1 | FileCheck %s
// RUN: not %clipc -T cs_6_6 -D SHARED %s -o %t 2>&1 | FileCheck %s --check-prefix=SHARED
RWStructuredBuffer<int> integers;
RWBuffer<float> typed;
groupshared float sums[8];
groupshared float4 rows[8];
groupshared float whole[2];
void Change(inout float x) { x += 1; }

[numthreads(8, 1, 1)]
void main(uint i : SV_GroupIndex) {
  float old;
#ifndef SHARED
  // CHECK: [[#@LINE+1]]:39: error: `InterlockedCompareStoreFloatBitwise` changes {{.*}}, that is a `float` [intrinsic-atomic-target, X3013]
  InterlockedCompareStoreFloatBitwise(integers[i], 1, 2);
  // CHECK: [[#@LINE+1]]:18: error: `InterlockedAdd` changes {{.*}}, that is an `int` or `uint` [intrinsic-atomic-target, X3013]
  InterlockedAdd(sums[i], 1);
  // CHECK: [[#@LINE+1]]:23: error: `InterlockedExchange` changes {{.*}}, that is an `int`, `uint` or `float` [intrinsic-atomic-target, X3013]
  InterlockedExchange(old, 1, old);
  // CHECK: [[#@LINE+1]]:3: error: `InterlockedCompareExchangeFloatBitwise` compares floats by their bits, which GLSL has no operation for in typed buffers and textures; change a float of a structured or byte address buffer, or a `groupshared` one [intrinsic-atomic, X4532]
  InterlockedCompareExchangeFloatBitwise(typed[i], 1, 2, old);
  // CHECK: [[#@LINE+1]]:14: error: `ddx` is the difference between neighbouring threads, which compute shaders have from cs_6_6 on; clipc does not translate it; exchange the values by `groupshared` memory or by `QuadReadAcrossX` [intrinsic-compute-derivative, X4532]
  typed[i] = ddx(old);
#else
  InterlockedExchange(sums[i], 1, old);
  // SHARED: [[#@LINE+1]]:3: error: `sums` is changed by an atomic operation of floats, which GLSL has of integers only: it is a `float` or an array of them, and a shader reads and assigns one at a time; copy it to a variable first [shared-float-use]
  sums[i] += 1;
  // SHARED: [[#@LINE+1]]:5: error: `sums` is changed
  ++sums[i];
  // SHARED: [[#@LINE+1]]:10: error: `sums` is changed
  Change(sums[i]);
  // SHARED: error: `rows` is changed
  InterlockedExchange(rows[i].x, 1, old);
  InterlockedExchange(whole[0], 1, old);
  // SHARED: [[#@LINE+1]]:19: error: `whole` is changed
  float copy[2] = whole;
  typed[i] = copy[0];
#endif
}
