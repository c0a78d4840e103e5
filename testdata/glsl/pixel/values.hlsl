// What the rasterizer gives, and what it takes besides colors.
// RUN: %clipc -T ps_5_0 --validate --verify %s -o - | FileCheck %s
// RUN: %clipc -T ps_5_0 --target=vulkan --validate --verify %s -o - | FileCheck %s
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

float4 unread(float4 distances : SV_ClipDistance, float2 uv : UV) : SV_Target { return uv.x; }
// UNREAD: layout(location = 0) in vec2 vs_UV0;
