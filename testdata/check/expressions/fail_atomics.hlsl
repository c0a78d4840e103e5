// What no atomic operation changes: a float, several numbers, a buffer that is only read.
// RUN: not %clipc -T vs_5_0 %s -o %t 2>&1 | FileCheck %s
// AUTOUPDATE
struct Pair { uint count; float weight; };
RWStructuredBuffer<Pair> pairs;
RWStructuredBuffer<uint2> twos;
RWStructuredBuffer<float> floats;
StructuredBuffer<uint> fixed_counts;
RWByteAddressBuffer bytes;
uint plain;

float4 main(float4 p : POSITION) : SV_Position {
// CHECK: fail_atomics.hlsl:[[#@LINE+3]]:18: error: `InterlockedAdd` changes an element of an unordered access view, `buffer[i]`, a member of one of a structured buffer, or a `groupshared` variable, that is an `int` or `uint` [intrinsic-atomic-target, X3013]
// CHECK-NEXT:    [[#@LINE+2]] |   InterlockedAdd(pairs[0].weight, 1);
// CHECK-NEXT:       |                  ^~~~~~~~~~~~~~~
  InterlockedAdd(pairs[0].weight, 1);
// CHECK-NEXT: fail_atomics.hlsl:[[#@LINE+3]]:18: error: `InterlockedAdd` changes an element of an unordered access view, `buffer[i]`, a member of one of a structured buffer, or a `groupshared` variable, that is an `int` or `uint` [intrinsic-atomic-target, X3013]
// CHECK-NEXT:    [[#@LINE+2]] |   InterlockedAdd(twos[0].yx, 1);
// CHECK-NEXT:       |                  ^~~~~~~~~~
  InterlockedAdd(twos[0].yx, 1);
// CHECK-NEXT: fail_atomics.hlsl:[[#@LINE+3]]:18: error: `InterlockedAdd` changes an element of an unordered access view, `buffer[i]`, a member of one of a structured buffer, or a `groupshared` variable, that is an `int` or `uint` [intrinsic-atomic-target, X3013]
// CHECK-NEXT:    [[#@LINE+2]] |   InterlockedAdd(floats[0], 1);
// CHECK-NEXT:       |                  ^~~~~~~~~
  InterlockedAdd(floats[0], 1);
// CHECK-NEXT: fail_atomics.hlsl:[[#@LINE+3]]:18: error: `InterlockedAdd` changes an element of an unordered access view, `buffer[i]`, a member of one of a structured buffer, or a `groupshared` variable, that is an `int` or `uint` [intrinsic-atomic-target, X3013]
// CHECK-NEXT:    [[#@LINE+2]] |   InterlockedAdd(fixed_counts[0], 1);
// CHECK-NEXT:       |                  ^~~~~~~~~~~~~~~
  InterlockedAdd(fixed_counts[0], 1);
// CHECK-NEXT: fail_atomics.hlsl:[[#@LINE+3]]:18: error: `InterlockedAdd` changes an element of an unordered access view, `buffer[i]`, a member of one of a structured buffer, or a `groupshared` variable, that is an `int` or `uint` [intrinsic-atomic-target, X3013]
// CHECK-NEXT:    [[#@LINE+2]] |   InterlockedAdd(plain, 1);
// CHECK-NEXT:       |                  ^~~~~
  InterlockedAdd(plain, 1);
// CHECK-NEXT: fail_atomics.hlsl:[[#@LINE+3]]:3: error: `InterlockedExchange` takes 3 arguments; 2 given [intrinsic-argument-count, X3013]
// CHECK-NEXT:    [[#@LINE+2]] |   InterlockedExchange(twos[0], 1);
// CHECK-NEXT:       |   ^~~~~~~~~~~~~~~~~~~
  InterlockedExchange(twos[0], 1);
// CHECK-NEXT: fail_atomics.hlsl:[[#@LINE+3]]:9: error: `InterlockedCompareStore` takes 3 arguments; 4 given [intrinsic-argument-count, X3013]
// CHECK-NEXT:    [[#@LINE+2]] |   bytes.InterlockedCompareStore(0, 1, 2, p.x);
// CHECK-NEXT:       |         ^~~~~~~~~~~~~~~~~~~~~~~
  bytes.InterlockedCompareStore(0, 1, 2, p.x);
// CHECK-NEXT: fail_atomics.hlsl:[[#@LINE+3]]:30: error: argument 3 of `InterlockedAdd` is written to; it must be a variable or a part of one [intrinsic-out-argument, X3025]
// CHECK-NEXT:    [[#@LINE+2]] |   bytes.InterlockedAdd(0, 1, 2);
// CHECK-NEXT:       |                              ^
  bytes.InterlockedAdd(0, 1, 2);
  return p;
}
