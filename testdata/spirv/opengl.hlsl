// SPIR-V for OpenGL 4.5: SPIR-V 1.0 without sets, a texture and its sampler in one, the numbers of vertices and instances that OpenGL has,
// and derivatives along y turned round, as they are unless the image is upside down.
// RUN: %clipc -T ps_5_0 -G -S %s -o - | FileCheck %s
// RUN: %clipc -T ps_5_0 -G %s -o %t.spv && spirv-val --target-env opengl4.5 %t.spv
// RUN: %clipc -T ps_5_0 -G --flip-y -S %s -o - | FileCheck %s --check-prefix=TURNED
// RUN: %clipc -T vs_5_0 -E vertex -G -S %s -o - | FileCheck %s --check-prefix=VERTEX
// RUN: %clipc -T vs_5_0 -E vertex -G %s -o %t.spv && spirv-val --target-env opengl4.5 %t.spv
// RUN: %clipc -T ps_5_0 -spirv --target=glsl460 %s -o %t.spv && spirv-val --target-env opengl4.5 %t.spv
// RUN: %draw compare %s -T ps_5_0 --target glsl450
// CHECK: Version: 1.0
// CHECK: OriginUpperLeft
// CHECK: OpSource HLSL 500
// CHECK-NOT: DescriptorSet
// CHECK: OpTypeImage %float 2D 1 0 0 1 Unknown
// CHECK: OpTypeSampledImage
// CHECK: OpImageSampleDrefExplicitLod
// CHECK: OpFNegate
// CHECK: OpImage %
// CHECK: OpImageFetch
// TURNED: OriginLowerLeft
// TURNED-NOT: OpFNegate
Texture2D map : register(t1);
Texture2D shadows : register(t2);
SamplerState plain : register(s0);
SamplerComparisonState compares : register(s1);
RWTexture2D<uint> counts : register(u1);
cbuffer Frame : register(b2) {
  row_major float4x4 world;
};
float4 main(float4 p : SV_Position, float2 uv : UV) : SV_Target {
  float4 sum = map.SampleLevel(plain, uv, 0);
  sum.x += shadows.SampleCmpLevelZero(compares, uv, 0.5) + ddy(uv.y);
  counts[uint2(p.xy) % 16] = 3;
  return mul(sum, world) + shadows.Load(int3(1, 2, 0)) + counts[uint2(p.xy) % 16];
}

// VERTEX: OpExtension "SPV_KHR_shader_draw_parameters"
// VERTEX-DAG: BuiltIn VertexId
// VERTEX-DAG: BuiltIn BaseVertex
// VERTEX-DAG: BuiltIn InstanceId
// VERTEX-NOT: BuiltIn BaseInstance
float4 vertex(float4 p : POSITION, uint v : SV_VertexID, uint i : SV_InstanceID) : SV_Position { return mul(p, world) + v + i; }
