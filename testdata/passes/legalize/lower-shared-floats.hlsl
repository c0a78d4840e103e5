// What a group shares is words where atomic operations change floats in it.
// RUN: %clipc -T cs_6_0 %s --dump-after=lower-shared-floats -o %t 2>&1 | FileCheck %s
// CHECK: groupshared uint parts[2]
// CHECK: parts[0] = asuint(
// CHECK: asfloat(InterlockedExchange(parts[1], asuint(
groupshared float parts[2];
RWStructuredBuffer<float> result;
[numthreads(1, 1, 1)] void main() {
  float old;
  parts[0] = 3;
  InterlockedExchange(parts[1], parts[0], old);
  result[0] = old;
}
