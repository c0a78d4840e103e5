// A triangle's patch: control points as arrays, constants of the patch, the tessellator's own inputs, and outputs as a vertex shader's.
// RUN: %clipc %s -T ds_5_0 --depth-range=negative-one-to-one --validate -o - | FileCheck %s --check-prefix=CHECK
// RUN: %clipc %s -T ds_5_0 --target=glsl400 --validate -o - | FileCheck %s --check-prefix=OLD
// RUN: %clipc %s -T ds_5_0 --target=essl310 --validate -o - | FileCheck %s --check-prefix=ES
// RUN: %clipc %s -T ds_6_0 --target=vulkan --flip-y --validate -o - | FileCheck %s --check-prefix=VK
// RUN: %clipc %s -T ds_5_0 --target=hlsl -o %t.hlsl && FileCheck %s --check-prefix=HLSL < %t.hlsl
// RUN: %clipc %t.hlsl -T ds_5_0 --validate -o - | grep "gl_ClipDistance.0. = clipc_distances0"
// RUN: %clipc %s -T ds_5_1 -spirv -fspv-target-env=vulkan1.0 -o %t.spv
struct Point {
  float4 position : SV_Position;
  float3 normal : NORMAL;
  float2 uv[2] : TEXCOORD;
};
struct Constants {
  float edges[3] : SV_TessFactor;
  float inside : SV_InsideTessFactor;
  float4 color : COLOR;
  uint kind : KIND;
};
struct Vertex {
  float4 position : SV_Position;
  float3 normal : NORMAL;
  float4 uv : TEXCOORD;
  nointerpolation uint kind : KIND;
};
cbuffer Frame {
  float4x4 view_projection;
  float4 plane;
  float height;
};

// OLD: #version 400
// OLD-NOT: location
// ES: #version 310 es
// ES: #extension GL_EXT_tessellation_shader : require
// CHECK: layout(triangles, fractional_odd_spacing, ccw) in;
// VK: layout(triangles, fractional_odd_spacing, cw) in;
// VK: gl_Position.y = -gl_Position.y;
// CHECK: layout(location = 0) in vec3 hs_NORMAL0[];
// CHECK: layout(location = 3) patch in vec4 hs_patch_COLOR0;
// CHECK-NEXT: layout(location = 4) patch in uint hs_patch_KIND0;
// CHECK: out float gl_ClipDistance[1];
// HLSL: {{^}}    clipc_distances0 = dot(clipc_result.position, plane);
// CHECK: gl_TessLevelOuter[1];
// CHECK: gl_TessLevelInner[0];
// CHECK: gl_in[i].gl_Position * at[i]
[domain("tri")]
[clipplanes(plane)]
Vertex main(Constants constants, float3 at : SV_DomainLocation, uint id : SV_PrimitiveID, const OutputPatch<Point, 3> patch) {
  Vertex vertex;
  float4 position = 0;
  float3 normal = 0;
  [unroll] for (int i = 0; i < 3; ++i) {
    position += patch[i].position * at[i];
    normal += patch[i].normal * at[i];
  }
  position.xyz += normalize(normal) * (height + constants.edges[1] - constants.inside);
  vertex.position = mul(view_projection, position);
  vertex.normal = normal;
  vertex.uv = float4(patch[0].uv[0] * at.x + patch[1].uv[1] * at.y, constants.color.xy);
  vertex.kind = constants.kind + id;
  return vertex;
}

[domain("tri")] [partitioning("fractional_odd")] [outputtopology("triangle_cw")] [outputcontrolpoints(3)] [patchconstantfunc("Cut")]
Point hull(InputPatch<Point, 3> patch, uint id : SV_OutputControlPointID) { return patch[id]; }
