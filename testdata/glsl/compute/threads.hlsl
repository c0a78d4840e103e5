// The numbers of a thread and of its group, whole and in parts, as uint and as int; the size of a group may be a
// constant expression.
// RUN: %clipc %s -T cs_5_0 --validate -o - | FileCheck %s --check-prefix=CHECK
// RUN: %clipc %s -T cs_4_0 -D OLD --validate -o - | FileCheck %s --check-prefix=OLD
// RUN: %clipc %s -T cs_5_0 --target=essl310 --validate -o - | FileCheck %s --check-prefix=CHECK
// RUN: %clipc %s -T cs_6_0 --target=vulkan --validate -o - | FileCheck %s --check-prefix=CHECK
// RUN: %clipc %s -T cs_5_0 --target=glsl430 --validate -o %t && %validate -S comp %t
#ifdef OLD
#define SIZE 16, 2, 1
#else
#define SIZE WIDTH * 2, WIDTH / 2, 1 + 1
#endif
static const int WIDTH = 4;
RWStructuredBuffer<uint> sums;
RWStructuredBuffer<int2> places;

// CHECK: layout(local_size_x = 8, local_size_y = 2, local_size_z = 2) in;
// OLD: layout(local_size_x = 16, local_size_y = 2, local_size_z = 1) in;
// CHECK: void main() {
// CHECK-NEXT: ivec2 place = ivec2(gl_GlobalInvocationID.xy);
// CHECK-NEXT: uvec3 group = gl_WorkGroupID;
// CHECK-NEXT: uint x = gl_LocalInvocationID.x;
// CHECK-NEXT: uint index = gl_LocalInvocationIndex;
[numthreads(SIZE)]
void main(int2 place : SV_DispatchThreadID, uint3 group : SV_GroupID, uint x : SV_GroupThreadID,
          uint index : SV_GroupIndex) {
  places[index] = place;
  sums[index] = group.x + group.z + x;
}
