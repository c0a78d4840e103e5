// Atomic operations on members and components of the elements of a structured buffer.
// RUN: %clipc -T ps_5_0 --validate --verify %s -o - | FileCheck %s
// RUN: %clipc -T ps_5_0 --target=vulkan --validate --verify %s -o - | FileCheck %s
// RUN: %clipc -T ps_5_0 --target=essl310 --validate --verify %s -o - | FileCheck %s
struct Inner {
  int2 range;
  uint counts[2];
};
struct Header {
  float weight;
  uint count;
  Inner inner[2];
};
RWStructuredBuffer<Header> headers : register(u1);
RWStructuredBuffer<uint4> vectors : register(u2);
uint main(float2 uv : UV) : SV_Target {
  uint before;
  int i = (int)uv.x;
  InterlockedAdd(headers[i].count, 1, before);
  InterlockedMax(headers[0].inner[1].counts[1], 7);
  InterlockedMin(headers[1].inner[0].range.y, -3);
  InterlockedCompareStore(headers[2].count, before, 5);
  InterlockedOr(vectors[i].z, 8);
  return before;
}
// CHECK: [[BEFORE:[a-zA-Z0-9_]+]] = atomicAdd(headers[i].count, 1u);
// CHECK: atomicMax(headers[0].inner[1].counts[1], 7u);
// CHECK: atomicMin(headers[1].inner[0].range.y, -3);
// CHECK: atomicCompSwap(headers[2].count, [[BEFORE]], 5u);
// CHECK: atomicOr(vectors[i].z, 8u);
