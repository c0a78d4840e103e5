// Inputs that the rasterizer makes, and inputs at other places of the pixel.
// RUN: %clipc -T ps_6_4 --validate --verify %s -o - | FileCheck %s
// RUN: %clipc -T ps_6_4 --target=vulkan --validate --verify %s -o - | FileCheck %s --check-prefix=UPPER
// RUN: %clipc -T ps_6_4 --target=essl320 --validate --verify %s -o - | FileCheck %s --check-prefix=LOWER
// RUN: %clipc -T ps_6_4 -E vulkan --target=vulkan --validate --verify %s -o - | FileCheck %s --check-prefix=VULKAN
// RUN: %clipc -T ps_6_4 -E view --validate --verify %s -o - | FileCheck %s --check-prefix=VIEW
// RUN: %clipc -T ps_5_0 -E distances --validate --verify %s -o - | FileCheck %s --check-prefix=DISTANCES
// RUN: %clipc -T vs_5_0 -E vertex --validate --verify %s -o - | FileCheck %s --check-prefix=VERTEX
// RUN: %clipc -T ps_5_0 -E distances --target=vulkan --validate --verify %s -o - | FileCheck %s --check-prefix=DISTANCES
struct Input {
  float4 a : A;
  float b : B;
};
float4 main(Input i) : SV_Target {
  float4 c = EvaluateAttributeCentroid(i.a) + EvaluateAttributeAtCentroid(i.b);
  c += EvaluateAttributeAtSample(i.a, 2);
  c.xy += EvaluateAttributeSnapped(i.a, int2(-8, 7)).xy + EvaluateAttributeSnapped(i.a.zw, int2(1, 1));
  return c;
}
// CHECK: interpolateAtCentroid(vs_A0) + interpolateAtCentroid(vs_B0)
// CHECK: interpolateAtSample(vs_A0, int(2u))
// CHECK: interpolateAtOffset(vs_A0, vec2(ivec2(-8, 7)) * vec2(0.0625, -0.0625)).xy + interpolateAtOffset(vs_A0, vec2(ivec2(1)) * vec2(0.0625, -0.0625)).zw
// UPPER: interpolateAtOffset(vs_A0, vec2(ivec2(-8, 7)) * 0.0625).xy
// LOWER: interpolateAtOffset(vs_A0, vec2(ivec2(-8, 7)) * vec2(0.0625, -0.0625)).xy

float4 vulkan(float3 weights : SV_Barycentrics, noperspective float3 flat_weights : SV_Barycentrics1, uint view : SV_ViewID,
              uint rate : SV_ShadingRate) : SV_Target {
  return float4(weights + flat_weights, view + rate);
}
// VULKAN: #extension GL_EXT_fragment_shader_barycentric : require
// VULKAN: #extension GL_EXT_fragment_shading_rate : require
// VULKAN: #extension GL_EXT_multiview : require
// VULKAN: weights = gl_BaryCoordEXT;
// VULKAN-NEXT: flat_weights = gl_BaryCoordNoPerspEXT;
// VULKAN-NEXT: uint(gl_ViewIndex);
// VULKAN-NEXT: uint(gl_ShadingRateEXT);

uint view(uint view : SV_ViewID, uint instance : SV_InstanceID) : SV_Target { return view + instance; }
// VIEW: #extension GL_OVR_multiview2 : require
// VIEW-NOT: num_views
// VIEW: flat in uint vs_SV_INSTANCEID0;
// VIEW: view = uint(gl_ViewID_OVR);
// VIEW-NEXT: view + vs_SV_INSTANCEID0

// The two shaders pack the distances alike.
struct Varyings {
  float4 position : SV_Position;
  float3 second : SV_ClipDistance1;
  float3 first : SV_ClipDistance0;
  float cull : SV_CullDistance;
};
float4 distances(Varyings i) : SV_Target { return float4(i.first.x, i.second.xy, i.cull); }
// DISTANCES: in float gl_ClipDistance[7];
// DISTANCES: in float gl_CullDistance[1];
// DISTANCES: gl_ClipDistance[4], gl_ClipDistance[5], gl_ClipDistance[6]
// DISTANCES: gl_ClipDistance[0], gl_ClipDistance[1], gl_ClipDistance[2]
// DISTANCES: gl_CullDistance[0]

Varyings vertex(float4 p : POSITION) {
  Varyings o = {p, p.xyz, p.yzw, p.w};
  return o;
}
// VERTEX: gl_ClipDistance[4] = {{.*}}.x;
// VERTEX: gl_ClipDistance[6] = {{.*}}.z;
