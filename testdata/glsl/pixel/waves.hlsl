// Wave and quad operations are those of GL_KHR_shader_subgroup. Oracle: "HLSL Shader Model 6 Wave Intrinsics" of Microsoft's wiki, and the
// table of dxc's SPIR-V manual, which maps them to the same operations. A function of a vector in HLSL that GLSL has for the whole
// vector only, subgroupAllEqual, is called by component.
// RUN: %clipc -T ps_6_6 --validate %s -o - | FileCheck %s
// RUN: %clipc -T ps_6_6 --target=vulkan --validate %s -o %t
// RUN: %clipc -T ps_6_6 --target=essl320 --validate %s -o %t
// RUN: %clipc -T ps_6_6 --target=glsl140 -E quads --validate %s -o - | FileCheck %s --check-prefix=QUADS
// RUN: %clipc -T ps_6_6 -E parts --validate %s -o - | FileCheck %s --check-prefix=PARTS
// RUN: %clipc -T vs_6_0 -E vertex --validate %s -o - | FileCheck %s --check-prefix=VERTEX
// RUN: %clipc -T ps_6_6 -E waiting --validate %s -o - | FileCheck %s --check-prefix=WAITING
// CHECK: #extension GL_KHR_shader_subgroup_arithmetic : require
// CHECK: #extension GL_KHR_shader_subgroup_vote : require
float4 main(float4 a : A, nointerpolation uint n : N) : SV_Target {
  // CHECK: vec4 r = subgroupAdd(vs_A0) + subgroupExclusiveAdd(vs_A0) * subgroupExclusiveMul(vs_A0);
  float4 r = WaveActiveSum(a) + WavePrefixSum(a) * WavePrefixProduct(a);
  // CHECK: if (gl_SubgroupInvocationID == subgroupBroadcastFirst(gl_SubgroupInvocationID)) {
  // CHECK: r += float(gl_SubgroupInvocationID * gl_SubgroupSize);
  if (WaveIsFirstLane()) r += WaveGetLaneIndex() * WaveGetLaneCount();
  // CHECK: r += float(subgroupBallotBitCount(subgroupBallot(vs_A0.x > 0.0)) + subgroupBallotExclusiveBitCount(subgroupBallot(vs_A0.y > 0.0)));
  r += WaveActiveCountBits(a.x > 0) + WavePrefixCountBits(a.y > 0);
  // CHECK: r += vec4(subgroupBallot(vs_A0.x > 0.5));
  r += WaveActiveBallot(a.x > 0.5);
  // CHECK: r += vec4(WaveActiveAllEqual(vs_A0));
  r += WaveActiveAllEqual(a);
  // CHECK: r += subgroupShuffle(vs_A0, vs_N0) + subgroupBroadcastFirst(vs_A0);
  r += WaveReadLaneAt(a, n) + WaveReadLaneFirst(a);
  // CHECK: r += float(((subgroupAnd(vs_N0) | subgroupOr(vs_N0)) ^ subgroupXor(vs_N0)) + subgroupMax(vs_N0) * subgroupMin(vs_N0));
  r += ((WaveActiveBitAnd(n) | WaveActiveBitOr(n)) ^ WaveActiveBitXor(n)) + WaveActiveMax(n) * WaveActiveMin(n);
  // A side with a wave operation is evaluated by all: no && of GLSL stands before it.
  // CHECK: bool all_positive = subgroupAll(vs_A0.x > 0.0);
  const bool all_positive = WaveActiveAllTrue(a.x > 0), any_positive = WaveActiveAnyTrue(a.x > 0);
  return all_positive != any_positive ? r : r * WaveActiveProduct(a.x);
}
float4 quads(float4 a : A, nointerpolation uint n : N) : SV_Target {
  // QUADS: #extension GL_KHR_shader_subgroup_quad : require
  // QUADS: vec4 r = subgroupQuadSwapHorizontal(vs_A0) + subgroupQuadSwapVertical(vs_A0) * subgroupQuadSwapDiagonal(vs_A0);
  float4 r = QuadReadAcrossX(a) + QuadReadAcrossY(a) * QuadReadAcrossDiagonal(a);
  // GLSL's function takes constants only.
  // QUADS: r += subgroupQuadBroadcast(vs_A0, 2u) + subgroupShuffle(vs_A0, (gl_SubgroupInvocationID & ~3u) + (vs_N0));
  r += QuadReadLaneAt(a, 2) + QuadReadLaneAt(a, n);
  return QuadAny(a.x > 0) || QuadAll(a.y > 0) ? r : 0;
}
float4 parts(nointerpolation uint n : N, float4 a : A) : SV_Target {
  // PARTS: #extension GL_NV_shader_subgroup_partitioned : require
  // PARTS: uvec4 m = subgroupPartitionNV(vs_N0);
  uint4 m = WaveMatch(n);
  // PARTS: subgroupPartitionedExclusiveAddNV(vs_A0, m) + float(subgroupPartitionedExclusiveAddNV(uint(vs_A0.x > 0.0), m))
  return WaveMultiPrefixSum(a, m) + WaveMultiPrefixCountBits(a.x > 0, m);
}
// VERTEX: gl_Position = subgroupMax(in_POSITION0);
float4 vertex(float4 p : POSITION) : SV_Position { return WaveActiveMax(p); }
// A pixel whose discard waits for its neighbours' derivatives is a helper from then on.
float4 waiting(float2 a : A) : SV_Target {
  if (a.x < 0) discard;
  // WAITING: float d = float(gl_HelperInvocation || is_discarded ? 1 : 0);
  float d = IsHelperLane() ? 1 : 0;
  return ddx(a.x) + d;
}
