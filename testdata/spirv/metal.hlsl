// SPIRV-Cross's Metal has the clip distances and HLSL's offsets of clipc's modules.
// RUN: %clipc %s -T vs_5_0 -spirv -o %t.spv
// RUN: spirv-cross --msl --msl-version 20300 %t.spv | FileCheck %s
cbuffer Camera : register(b0) {
  float4x4 view_projection;
  float3 eye;
  float time;
};
cbuffer Planes : register(b1) {
  float4 water, portal;
};
// CHECK: struct Camera
// CHECK: packed_float3 eye;
// CHECK: struct main0_out
// CHECK: float2 vs_TEXCOORD0 {{\[\[}}user(locn0)]];
// CHECK: float4 gl_Position {{\[\[}}position]];
// CHECK: float gl_ClipDistance {{\[\[}}clip_distance]] [2];
// CHECK: vertex main0_out main0({{.*}}constant Camera& [[CAMERA:[A-Za-z_0-9]+]] {{\[\[}}buffer(0)]], constant Planes& [[PLANES:[A-Za-z_0-9]+]] {{\[\[}}buffer(1)]]
// CHECK: out.gl_ClipDistance[0u] = dot({{.*}}, [[PLANES]].water);
// CHECK: out.gl_ClipDistance[1u] = dot({{.*}}, [[PLANES]].portal);
[clipplanes(water, portal)]
float4 main(float3 position : POSITION, inout float2 uv : TEXCOORD0) : SV_Position {
  uv += eye.xy * time;
  return mul(float4(position, 1), view_projection);
}
