// Direct3D 9's pixel shaders: names of inputs and outputs, tex2D and its kin, and targets without `in` and `out`.
// RUN: %clipc -T ps_3_0 --validate --verify %s -o - | FileCheck %s
// RUN: %clipc -T ps_3_0 --target=essl100 --flip-y --verify %s -o - | FileCheck %s --check-prefix=ES
// RUN: %clipc -T ps_3_0 --target=glsl120 --flip-y --validate --verify %s -o - | FileCheck %s --check-prefix=OLD
// RUN: %clipc -T ps_3_0 -E centroid --validate --verify %s -o - | FileCheck %s --check-prefix=CENTROID
sampler2D map;
samplerCUBE sky;
struct Input {
  float4 position : POSITION;  // not passed on: the vertex shader's position
  float2 uv : TEXCOORD0;
  float3 direction : TEXCOORD1;
  float4 projected : TEXCOORD2;
  float4 color : COLOR0;
};
float4 main(Input i, float2 pixel : VPOS, float face : VFACE, out float4 second : COLOR1, out float depth : DEPTH) : COLOR0 {
  second = texCUBEbias(sky, float4(i.direction, 2)) + texCUBEproj(sky, i.projected);
  second += tex2D(map, i.uv, i.uv, i.uv * 2) + tex2Dlod(map, float4(i.uv, 0, 3));
  depth = pixel.x;
  return (tex2D(map, i.uv) + tex2Dproj(map, i.projected)) * i.color * face;
}
// CHECK: layout(location = 0) in vec2 vs_TEXCOORD0;
// CHECK: layout(location = 3) in vec4 vs_COLOR0;
// CHECK: layout(location = 0) out vec4 SV_Target0;
// CHECK: layout(location = 1) out vec4 SV_Target1;
// CHECK: gl_FragCoord.xy - 0.5
// CHECK: gl_FrontFacing ? 1.0 : -1.0
// CHECK: texture(sky, vs_TEXCOORD1, 2.0) + texture(sky, vs_TEXCOORD2.xyz / vs_TEXCOORD2.w)
// CHECK: textureGrad(map, vs_TEXCOORD0, vs_TEXCOORD0, vs_TEXCOORD0 * 2.0) + textureLod(map, vs_TEXCOORD0, 3.0)
// CHECK: gl_FragDepth = {{.*}}.x
// CHECK: texture(map, vs_TEXCOORD0) + textureProj(map, vs_TEXCOORD2)

// ES: #extension GL_EXT_draw_buffers : require
// ES-NEXT: #extension GL_EXT_frag_depth : require
// ES-NEXT: #extension GL_EXT_shader_texture_lod : require
// ES: varying vec2 vs_TEXCOORD0;
// ES: SV_Target1 = textureCube(sky, vs_TEXCOORD1, 2.0)
// ES: texture2DGradEXT(map, {{.*}} + texture2DLodEXT(map, vs_TEXCOORD0, 3.0)
// ES: gl_FragDepthEXT = {{.*}}.x
// ES: (texture2D(map, vs_TEXCOORD0) + texture2DProj(map, vs_TEXCOORD2)) * vs_COLOR0 * face;
// ES: gl_FragData[0] = SV_Target0;
// ES-NEXT: gl_FragData[1] = SV_Target1;

// OLD: #extension GL_ARB_shader_texture_lod : require
// OLD: texture2DGradARB(map, {{.*}} + texture2DLod(map, vs_TEXCOORD0, 3.0)
// OLD: gl_FragDepth = {{.*}}.x

float4 centroid(float2 uv : TEXCOORD3_centroid, float4 color : Color_Centroid) : COLOR { return tex2D(map, uv) * color; }
// CENTROID: layout(location = 0) centroid in vec2 vs_TEXCOORD3;
// CENTROID-NEXT: layout(location = 1) centroid in vec4 vs_COLOR0;
