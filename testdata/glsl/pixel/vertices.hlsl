// GetAttributeAtVertex reads an input at one of the primitive's vertices: the input is an array of three. What reads it plainly has the
// first vertex's value, as Direct3D's flat inputs do.
// RUN: %clipc %s -T ps_6_1 -E ps --target=vulkan --validate -o - | FileCheck %s --check-prefixes=CHECK,VULKAN
// RUN: %clipc %s -T ps_6_1 -E ps --target=glsl450 --validate -o - | FileCheck %s --check-prefixes=CHECK,OPENGL
// RUN: %clipc %s -T ps_6_1 -E ps --target=essl320 --validate -o - | FileCheck %s --check-prefixes=CHECK,OPENGL
// VULKAN: #extension GL_EXT_fragment_shader_barycentric : require
// OPENGL: #extension GL_NV_fragment_shader_barycentric : require
// VULKAN: layout(location = 0) pervertexEXT in vec4 vs_COLOR0[3];
// OPENGL: layout(location = 0) pervertexNV in vec4 vs_COLOR0[3];
// CHECK: layout(location = 1) flat in vec2 vs_UV0;
// CHECK-NEXT: in uint vs_ID0[3];
struct Input {
  nointerpolation float4 color : COLOR;
  nointerpolation float2 uv : UV;
};


float4 ps(Input input, nointerpolation uint id : ID, float3 weights : SV_Barycentrics) : SV_Target {
  // CHECK: vs_COLOR0[1u] *
  float4 color = GetAttributeAtVertex(input.color, 1) * weights.y;
  // CHECK: vs_COLOR0[2u].xy
  color.xy += GetAttributeAtVertex(input.color.xy, 2) + input.uv;
  // CHECK: vs_COLOR0[0].x + float(vs_ID0[2u])
  color.z += input.color.x + GetAttributeAtVertex(id, 2);
  return color;
}
