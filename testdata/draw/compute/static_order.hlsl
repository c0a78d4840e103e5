// Initial values that change an object run in the order of the text, one that nothing names too, and one that reads the object with
// them.
// RUN: %clipc -T cs_5_0 -E group --validate %s -o - | FileCheck %s
// RUN: %draw compare %s -T cs_5_0 -E group
// RUN: %draw compare %s -T cs_6_0 -E group --target=vulkan
RWStructuredBuffer<uint> log_ : register(u0);
RWStructuredBuffer<uint> result : register(u1);
uint Count() { uint old; InterlockedAdd(log_[0], 1, old); return old; }
static uint counted = Count();
static uint read = log_[0];
static uint again = Count();
// CHECK: void main() {
// CHECK-NEXT: counted = Count();
// CHECK-NEXT: read = log_[0];
// CHECK-NEXT: again = Count();
// CHECK-NEXT: result[0] = read;
// CHECK-NEXT: }
[numthreads(1, 1, 1)] void group() { result[0] = read; }
