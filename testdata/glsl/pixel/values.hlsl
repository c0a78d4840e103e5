// What the rasterizer gives, and what it takes besides colors.
// RUN: %clipc -T ps_5_0 --validate --verify %s -o - | FileCheck %s
// RUN: %clipc -T ps_5_0 --target=vulkan --validate --verify %s -o - | FileCheck %s
// RUN: not %clipc -T ps_5_0 --target=essl300 %s -o - 2>&1 | FileCheck %s --check-prefix=ES
// RUN: not %clipc -T ps_6_1 -E unknown %s -o - 2>&1 | FileCheck %s --check-prefix=UNKNOWN
// RUN: %clipc -T ps_5_0 -E unread --validate %s -o - | FileCheck %s --check-prefix=UNREAD
struct Output {
  float4 color : SV_Target;
  float depth : SV_DepthGreaterEqual;
  uint mask : SV_Coverage;
};
[earlydepthstencil]
Output main(bool front : SV_IsFrontFace, uint sample_index : SV_SampleIndex, uint covered : SV_Coverage,
            uint primitive : SV_PrimitiveID, uint layer : SV_RenderTargetArrayIndex,
            uint viewport : SV_ViewportArrayIndex) {
  Output o;
  o.color = front ? sample_index : primitive + layer + viewport;
  o.depth = 0.5;
  o.mask = covered & 3;
  return o;
}
// CHECK: layout(early_fragment_tests) in;
// CHECK: layout(depth_greater) out float gl_FragDepth;
// CHECK-DAG: gl_FrontFacing
// CHECK-DAG: uint(gl_SampleID)
// CHECK-DAG: uint(gl_SampleMaskIn[0])
// CHECK-DAG: uint(gl_PrimitiveID)
// CHECK-DAG: uint(gl_Layer)
// CHECK-DAG: uint(gl_ViewportIndex)
// CHECK: gl_FragDepth = 0.5;
// CHECK: gl_SampleMask[0] = int(
// ES-DAG: error: `SV_PrimitiveID` is an input or output that target `essl300` lacks [target-pixel-value]
// ES-DAG: error: `earlydepthstencil` is given; target `essl300` has no early tests; `glsl420`, `essl310` and `vulkan` have [target-early-tests]

float4 unknown(float3 weights : SV_Barycentrics) : SV_Target { return weights.xyzz; }
// UNKNOWN: [[#@LINE-1]]:33: error: `SV_Barycentrics` is read; clipc does not translate this input of a pixel shader for target `glsl450` [target-pixel-input]

float4 unread(float4 distances : SV_ClipDistance, float2 uv : UV) : SV_Target { return uv.x; }
// UNREAD: layout(location = 0) in vec2 vs_UV0;
