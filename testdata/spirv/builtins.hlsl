// Built-in inputs and outputs, with the capabilities and extensions that they need; inputs at other places of the pixel; the order of stores.
// RUN: %clipc -T vs_6_4 -E vertex -spirv -S %s -o - | FileCheck %s --check-prefix=VERTEX
// RUN: %clipc -T vs_6_4 -E vertex -spirv %s -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %clipc -T vs_6_4 -E vertex -spirv -fspv-target-env=vulkan1.2 -S %s -o - | FileCheck %s --check-prefix=CORE
// RUN: %clipc -T vs_6_4 -E vertex -spirv -fspv-target-env=vulkan1.2 %s -o %t.spv && spirv-val --target-env vulkan1.2 %t.spv
// RUN: %clipc -T ps_6_4 -E pixel -spirv -S %s -o - | FileCheck %s --check-prefix=PIXEL
// RUN: %clipc -T ps_6_4 -E pixel -spirv %s -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %clipc -T ps_6_4 -E pixel -spirv -fspv-target-env=vulkan1.3 %s -o %t.spv && spirv-val --target-env vulkan1.3 %t.spv
// RUN: %clipc -T ps_6_4 -E places -spirv -S %s -o - | FileCheck %s --check-prefix=PLACES
// RUN: %clipc -T ps_6_4 -E places -spirv %s -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %clipc -T ps_6_4 -E ordered -spirv -S %s -o - | FileCheck %s --check-prefix=ORDERED
// RUN: %clipc -T ps_6_4 -E ordered -spirv %s -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %clipc -T vs_6_4 -E vertex -G -S %s -o - | FileCheck %s --check-prefix=OPENGL
// RUN: %clipc -T vs_6_4 -E vertex -G %s -o %t.spv && spirv-val --target-env opengl4.5 %t.spv
// RUN: %clipc -T ps_6_4 -E pixel -G -S %s -o - | FileCheck %s --check-prefix=OPENGL-PIXEL
// RUN: %clipc -T ps_6_4 -E pixel -G %s -o %t.spv && spirv-val --target-env opengl4.5 %t.spv
// RUN: %clipc -T ps_6_4 -E places -G %s -o %t.spv && spirv-val --target-env opengl4.5 %t.spv
// OPENGL-DAG: OpExtension "SPV_KHR_multiview"
// OPENGL-DAG: BuiltIn ViewIndex
// OPENGL-PIXEL-DAG: OpExtension "SPV_NV_fragment_shader_barycentric"
// OPENGL-PIXEL-DAG: OpExtension "SPV_KHR_fragment_shading_rate"
// VERTEX-DAG: OpCapability ShaderViewportIndexLayerEXT
// VERTEX-DAG: OpCapability FragmentShadingRateKHR
// VERTEX-DAG: OpCapability MultiView
// VERTEX-DAG: OpExtension "SPV_EXT_shader_viewport_index_layer"
// VERTEX-NOT: OpExtension "SPV_KHR_multiview"
// VERTEX-DAG: BuiltIn Layer
// VERTEX-DAG: BuiltIn ViewportIndex
// VERTEX-DAG: BuiltIn PrimitiveShadingRateKHR
// VERTEX-DAG: BuiltIn ViewIndex
// CORE-DAG: OpCapability ShaderLayer
// CORE-DAG: OpCapability ShaderViewportIndex
// CORE-NOT: SPV_EXT_shader_viewport_index_layer
struct Vertex {
  float4 position : SV_Position;
  uint layer : SV_RenderTargetArrayIndex;
  uint viewport : SV_ViewportArrayIndex;
  uint rate : SV_ShadingRate;
};
Vertex vertex(float4 p : POSITION, uint view : SV_ViewID) {
  Vertex v = {p, view, view + 1, 5};
  return v;
}

// PIXEL-DAG: OpCapability StencilExportEXT
// PIXEL-DAG: OpExecutionMode %main StencilRefReplacingEXT
// PIXEL-DAG: OpExecutionMode %main DepthGreater
// PIXEL-DAG: OpDecorate %gl_SampleMask BuiltIn SampleMask
// PIXEL-DAG: OpDecorate %gl_SampleMaskIn BuiltIn SampleMask
// PIXEL-DAG: OpDecorate %gl_SampleMaskIn Flat
// PIXEL-DAG: OpDecorate %gl_HelperInvocation BuiltIn HelperInvocation
// PIXEL-DAG: OpDecorate %gl_BaryCoordEXT BuiltIn BaryCoordKHR
// PIXEL-DAG: OpDecorate %gl_Layer BuiltIn Layer
// PIXEL-DAG: OpDecorate %gl_ShadingRateEXT BuiltIn ShadingRateKHR
// PIXEL-DAG: OpDecorate %gl_ClipDistance BuiltIn ClipDistance
struct Pixel {
  float4 color : SV_Target;
  float depth : SV_DepthGreaterEqual;
  uint coverage : SV_Coverage;
  uint stencil : SV_StencilRef;
};
Pixel pixel(float4 p : SV_Position, uint mask : SV_Coverage, uint layer : SV_RenderTargetArrayIndex, uint viewport : SV_ViewportArrayIndex,
            float3 weights : SV_Barycentrics, uint rate : SV_ShadingRate, uint primitive : SV_PrimitiveID, float2 planes : SV_ClipDistance) {
  Pixel result;
  result.color = float4(weights, layer + viewport + rate + primitive) + planes.xyxy;
  result.depth = p.z;
  result.coverage = mask & (IsHelperLane() ? 1 : 3);
  result.stencil = layer;
  return result;
}

// PLACES: OpCapability InterpolationFunction
// PLACES: OpDecorate %vs_N0 PerVertexKHR
// PLACES: OpExtInst %v4float {{%[0-9]+}} InterpolateAtCentroid %vs_A0
// PLACES: OpExtInst %v4float {{%[0-9]+}} InterpolateAtSample %vs_A0
// PLACES: OpExtInst %v4float {{%[0-9]+}} InterpolateAtOffset %vs_A0
// PLACES: OpAccessChain %_ptr_Input_uint %vs_N0 %uint_2
// PLACES: OpAccessChain %_ptr_Input_uint %vs_N0 %int_0
float4 places(float4 a : A, nointerpolation uint n : N) : SV_Target {
  float4 c = EvaluateAttributeCentroid(a) + EvaluateAttributeAtSample(a.wzyx, n);
  c.xy += EvaluateAttributeSnapped(a, int2(-8, 7)).xy;
  return c + GetAttributeAtVertex(n, 2) + n;
}

// ORDERED: OpExecutionMode %main PixelInterlockOrderedEXT
// ORDERED: OpDecorate %layers Coherent
// ORDERED: OpBeginInvocationInterlockEXT
// ORDERED: OpMemoryBarrier %uint_1 %uint_2120
// ORDERED: OpEndInvocationInterlockEXT
// ORDERED-NEXT: OpReturn
RasterizerOrderedTexture2D<float4> layers : register(u1);
float4 ordered(float4 p : SV_Position) : SV_Target {
  const float4 old = layers[p.xy];
  layers[p.xy] = old * 0.5 + p;
  DeviceMemoryBarrier();
  return old;
}
