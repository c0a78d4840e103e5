// A vertex shader as SPIR-V: its language, its names, the places of its buffer, a clip distance for each plane.
// RUN: %clipc -T vs_5_1 -spirv -S %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_1 -spirv %s -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %clipc -T vs_5_1 -spirv -fspv-target-env=vulkan1.0 %s -o %t.spv && spirv-val --target-env vulkan1.0 %t.spv
// RUN: %clipc -T vs_5_1 -spirv -fspv-target-env=vulkan1.2 %s -o %t.spv && spirv-val --target-env vulkan1.2 %t.spv
// RUN: %clipc -T vs_5_1 -spirv -fspv-target-env=vulkan1.3 %s -o %t.spv && spirv-val --target-env vulkan1.3 %t.spv
// RUN: %clipc -T vs_5_1 -spirv -S -e draw --source-entrypoint main %s -o - | FileCheck %s --check-prefix=ENTRY
// RUN: %draw compare %s -T vs_5_1 --target vulkan
// ENTRY: OpEntryPoint Vertex %main "draw"
cbuffer Frame : register(b3, space1) {
  float4x4 world;
  row_major float4x4 view;
  float4 planes[2];
  bool is_lit;
};
struct Varyings {
  float4 position : SV_Position;
  nointerpolation uint id : ID;
  float3 color : COLOR;
};

// CHECK:     OpCapability ClipDistance
// CHECK:     OpCapability DrawParameters
// CHECK-NOT: OpCapability
// CHECK:     OpEntryPoint Vertex %main "main" %in_POSITION0 %vs_ID0 %vs_COLOR0 %gl_Position %gl_ClipDistance %gl_VertexIndex %gl_BaseVertex
// CHECK:     OpSource HLSL 510
// CHECK:     OpMemberName %Frame 0 "world"
// CHECK-DAG: OpDecorate %in_POSITION0 Location 0
// CHECK-DAG: OpDecorate %gl_Position BuiltIn Position
// CHECK-DAG: OpDecorate %vs_ID0 Flat
// CHECK-DAG: OpDecorate %vs_COLOR0 Location 1
// CHECK-DAG: OpMemberDecorate %Frame 0 RowMajor
// CHECK-DAG: OpMemberDecorate %Frame 1 Offset 64
// CHECK-DAG: OpMemberDecorate %Frame 1 ColMajor
// CHECK-DAG: OpDecorate %_arr_v4float_uint_2 ArrayStride 16
// CHECK-DAG: OpDecorate %Frame Block
// CHECK-DAG: OpDecorate %Frame_0 DescriptorSet 1
// CHECK-DAG: OpDecorate %Frame_0 Binding 3
// CHECK:     OpFunction %void None
// CHECK:     OpMatrixTimesVector
[clipplanes(planes[0], planes[1])]
Varyings main(float4 p : POSITION, uint vertex : SV_VertexID) {
  Varyings result;
  result.position = mul(mul(p, world), view);
  result.id = vertex * 2u;
  result.color = is_lit ? p.xyz : p.zyx * 0.5;
  return result;
}
