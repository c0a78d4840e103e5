// Barriers: of objects, of memory that a group shares, of both; with and without waiting for the group.
// RUN: %clipc %s -T cs_5_0 --validate -o - | FileCheck %s
// RUN: %clipc %s -T cs_5_0 --target=essl310 --validate -o - | FileCheck %s
// RUN: %clipc %s -T cs_6_0 --target=vulkan --validate -o - | FileCheck %s
// RUN: %clipc %s -T cs_5_0 -spirv -fspv-target-env=vulkan1.0 -o %t.spv && spirv-val --target-env vulkan1.0 %t.spv
// RUN: spirv-dis --raw-id %t.spv | FileCheck %s --check-prefix=SPIRV
groupshared float memory[64];
RWStructuredBuffer<float> result;

// SPIRV-DAG: [[GROUP:%[0-9]+]] = OpConstant {{.*}} 2
// SPIRV-DAG: [[DEVICE:%[0-9]+]] = OpConstant {{.*}} 1{{$}}
// SPIRV-DAG: [[SHARED:%[0-9]+]] = OpConstant {{.*}} 264
// SPIRV-DAG: [[OBJECTS:%[0-9]+]] = OpConstant {{.*}} 2120
// SPIRV-DAG: [[ALL:%[0-9]+]] = OpConstant {{.*}} 2376

// CHECK: void wait_for_group() {
// CHECK-NEXT: memoryBarrierShared();
// CHECK-NEXT: barrier();
// CHECK: void main() {
[numthreads(64, 1, 1)]
void main(uint index : SV_GroupIndex) {
  memory[index] = index;
  // CHECK: {{^}}    memoryBarrierShared();
  // CHECK-NEXT: {{^}}    barrier();
  // SPIRV: OpControlBarrier [[GROUP]] [[GROUP]] [[SHARED]]
  GroupMemoryBarrierWithGroupSync();
  float value = memory[63 - index];
  // CHECK: memoryBarrierShared();
  // SPIRV: OpMemoryBarrier [[GROUP]] [[SHARED]]
  GroupMemoryBarrier();
  result[index] = value;
  // CHECK: memoryBarrier();
  // SPIRV: OpMemoryBarrier [[DEVICE]] [[OBJECTS]]
  DeviceMemoryBarrier();
  result[index + 64] = value;
  // CHECK: memoryBarrier();
  // CHECK-NEXT: barrier();
  // SPIRV: OpControlBarrier [[GROUP]] [[DEVICE]] [[OBJECTS]]
  DeviceMemoryBarrierWithGroupSync();
  // CHECK-NEXT: memoryBarrier();
  // SPIRV: OpMemoryBarrier [[DEVICE]] [[ALL]]
  AllMemoryBarrier();
  // CHECK-NEXT: memoryBarrier();
  // CHECK-NEXT: barrier();
  // SPIRV: OpControlBarrier [[GROUP]] [[DEVICE]] [[ALL]]
  AllMemoryBarrierWithGroupSync();
  // CHECK: i < 4; wait_for_group(), i++
  for (int i = 0; i < 4; GroupMemoryBarrierWithGroupSync(), i++) result[index] += memory[i];
}
