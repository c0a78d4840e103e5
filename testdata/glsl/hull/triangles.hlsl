// Triangles: the control points are written before the barrier, and the first of them writes what the patch has once.
// RUN: %clipc %s -T hs_5_0 --validate -o - | FileCheck %s
// RUN: %clipc %s -T hs_5_0 --target=glsl400 --validate -o - | FileCheck %s --check-prefix=OLD
// RUN: %clipc %s -T hs_5_0 --target=essl310 --validate -o - | FileCheck %s --check-prefix=ES
// RUN: %clipc %s -T hs_5_0 --target=essl320 --validate -o %t.es && %validate -S tesc %t.es
// RUN: %clipc %s -T hs_6_0 --target=vulkan --validate -o - | FileCheck %s
// RUN: %clipc %s -T hs_5_1 -spirv -fspv-target-env=vulkan1.0 -o %t.spv
// RUN: %clipc %s -T hs_5_0 --target=hlsl -o - | diff %s -
// RUN: %draw compare %s -T hs_5_0
struct Corner {
  float4 position : SV_Position;
  float3 normal : NORMAL;
  float2 uv : TEXCOORD0;
};
struct Point {
  float3 position : POSITION;
  float3 normal : NORMAL;
};
struct Constants {
  float edges[3] : SV_TessFactor;
  float inside : SV_InsideTessFactor;
  float3 middle : MIDDLE;
};
cbuffer Frame {
  float level;
};

// OLD: #version 400
// ES: #version 310 es
// ES-NEXT: #extension GL_EXT_tessellation_shader : require
// CHECK: layout(vertices = 3) out;
// CHECK: layout(location = 1) in vec2 vs_TEXCOORD0[];
// CHECK: layout(location = 0) out vec3 hs_POSITION0[];
// CHECK: layout(location = 1) out vec3 hs_NORMAL0[];
// CHECK: layout(location = 2) patch out vec3 hs_patch_MIDDLE0;
// OLD: out vec3 hs_POSITION0[];
// OLD: patch out vec3 hs_patch_MIDDLE0;
// CHECK: hs_POSITION0[gl_InvocationID] =
// CHECK: barrier();
// CHECK-NEXT: if (gl_InvocationID == 0) {
// CHECK: vs_TEXCOORD0[k].x
// CHECK: hs_POSITION0[1]
// CHECK: hs_patch_MIDDLE0 =
// CHECK: gl_TessLevelOuter[0] = min(
// CHECK: gl_TessLevelOuter[2] = min(
// CHECK: gl_TessLevelInner[0] = min(
Constants OfPatch(InputPatch<Corner, 3> patch, const OutputPatch<Point, 3> points, uint id : SV_PrimitiveID) {
  Constants constants;
  for (int k = 0; k < 3; ++k) constants.edges[k] = level + patch[k].uv.x;
  constants.inside = level * id;
  constants.middle = (points[0].position + points[1].position + points[2].position) / 3;
  return constants;
}
[domain("tri")]
[partitioning("fractional_odd")]
[outputtopology("triangle_cw")]
[outputcontrolpoints(3)]
[patchconstantfunc("OfPatch")]
[maxtessfactor(20)]
Point main(InputPatch<Corner, 3> patch, uint i : SV_OutputControlPointID, uint id : SV_PrimitiveID) {
  Point p;
  p.position = patch[i].position.xyz;
  p.normal = patch[i].normal * id;
  return p;
}
