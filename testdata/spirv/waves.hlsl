// Functions of waves and of quads: operations of groups that are not uniform, which SPIR-V has from 1.3 on.
// RUN: %clipc -T ps_6_5 -spirv -S %s -o - | FileCheck %s
// RUN: %clipc -T ps_6_5 -spirv %s -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %clipc -T ps_6_5 -spirv -fspv-target-env=vulkan1.3 %s -o %t.spv && spirv-val --target-env vulkan1.3 %t.spv
// CHECK-DAG: OpCapability GroupNonUniformVote
// CHECK-DAG: OpCapability GroupNonUniformBallot
// CHECK-DAG: OpCapability GroupNonUniformArithmetic
// CHECK-DAG: OpCapability GroupNonUniformShuffle
// CHECK-DAG: OpCapability GroupNonUniformQuad
// CHECK-DAG: OpCapability GroupNonUniformPartitionedNV
// CHECK-DAG: OpExtension "SPV_NV_shader_subgroup_partitioned"
// CHECK-DAG: OpDecorate %gl_SubgroupInvocationID BuiltIn SubgroupLocalInvocationId
// CHECK-DAG: OpDecorate %gl_SubgroupInvocationID Flat
float4 main(float4 p : P, nointerpolation uint n : N, nointerpolation int i : I) : SV_Target {
  // CHECK: OpGroupNonUniformFAdd %v4float %uint_3 Reduce
  float4 sum = WaveActiveSum(p);
  // CHECK: OpGroupNonUniformSMin %int %uint_3 Reduce
  // CHECK: OpGroupNonUniformUMax %uint %uint_3 Reduce
  sum.x += WaveActiveMin(i) + WaveActiveMax(n);
  // CHECK: OpGroupNonUniformFMul %v4float %uint_3 ExclusiveScan
  sum += WavePrefixProduct(p);
  // CHECK: OpGroupNonUniformBitwiseXor %uint %uint_3 Reduce
  sum.y += WaveActiveBitXor(n);
  // CHECK: OpGroupNonUniformBallot %v4uint %uint_3
  // CHECK: OpGroupNonUniformBallotBitCount %uint %uint_3 ExclusiveScan
  sum.z += WavePrefixCountBits(p.x > 0);
  // CHECK: OpGroupNonUniformAll %bool %uint_3
  sum.w += WaveActiveAllTrue(p.x > 0.5) ? 1 : 0;
  // CHECK: OpGroupNonUniformShuffle %v4float %uint_3
  // CHECK: OpGroupNonUniformBroadcastFirst %v4float %uint_3
  sum += WaveReadLaneAt(p, n) + WaveReadLaneFirst(p);
  // CHECK: OpGroupNonUniformPartitionNV %v4uint
  // CHECK: OpGroupNonUniformIAdd %uint %uint_3 PartitionedExclusiveScanNV
  sum.x += WaveMultiPrefixSum(n, WaveMatch(i));
  // CHECK: OpGroupNonUniformQuadSwap %v4float %uint_3 {{%[0-9]+}} %uint_2
  // CHECK: OpGroupNonUniformQuadBroadcast %v4float %uint_3 {{%[0-9]+}} %uint_1
  sum += QuadReadAcrossDiagonal(p) + QuadReadLaneAt(p, 1);
  // CHECK: OpGroupNonUniformShuffle %v4float %uint_3
  return sum + QuadReadLaneAt(p, n & 3) + WaveGetLaneIndex() + WaveGetLaneCount() + WaveIsFirstLane();
}
