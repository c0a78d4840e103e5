// A pixel shader's inputs match the vertex shader's outputs, and its outputs go to render targets.
// RUN: %clipc -T ps_5_0 -E ps --validate --verify %s -o - | FileCheck %s
// RUN: %clipc -T ps_5_0 -E ps --target=glsl330 --validate --verify %s -o - | FileCheck %s --check-prefix=BYNAME
// RUN: %clipc -T ps_5_0 -E ps --target=vulkan --validate --verify %s -o - | FileCheck %s --check-prefix=VULKAN
// RUN: %clipc -T ps_5_0 -E ps --target=webgl2 --validate --verify %s -o - | FileCheck %s --check-prefix=ES
// RUN: %clipc -T ps_5_0 -E ps --target=vulkan -spirv %s -o %t.spv
// RUN: %clipc -T vs_5_0 -E vs --validate %s -o - | FileCheck %s --check-prefix=VERTEX
Texture2D albedo : register(t0);
SamplerState trilinear : register(s0);
cbuffer Material : register(b0) {
  float4 tint;
};
struct Varyings {
  float4 position : SV_Position;
  float2 uv : TEXCOORD0;
  nointerpolation uint id : ID;
  centroid float3 normal : NORMAL;
};
struct Targets {
  float4 color : SV_Target0;
  float2 motion : SV_Target2;
  uint id : SV_Target1;
};

Varyings vs(float4 p : POSITION, float2 uv : TEXCOORD0, float3 n : NORMAL, uint id : ID) {
  Varyings o;
  o.position = p;
  o.uv = uv;
  o.id = id;
  o.normal = n;
  return o;
}
// VERTEX: layout(location = 0) out vec2 vs_TEXCOORD0;
// VERTEX: layout(location = 1) flat out uint vs_ID0;
// VERTEX: layout(location = 2) centroid out vec3 vs_NORMAL0;

Targets ps(Varyings input) {
  Targets o;
  o.color = albedo.Sample(trilinear, input.uv) * tint;
  o.motion = input.normal.xy;
  o.id = input.id;
  return o;
}
// CHECK: #version 450
// CHECK: layout(binding = 16) uniform sampler2D albedo;
// CHECK: layout(location = 0) in vec2 vs_TEXCOORD0;
// CHECK-NEXT: layout(location = 1) flat in uint vs_ID0;
// CHECK-NEXT: layout(location = 2) centroid in vec3 vs_NORMAL0;
// CHECK: layout(location = 0) out vec4 SV_Target0;
// CHECK-NEXT: layout(location = 1) out uint SV_Target1;
// CHECK-NEXT: layout(location = 2) out vec2 SV_Target2;
// CHECK: void main() {
// CHECK-NEXT: SV_Target0 = texture(albedo, vs_TEXCOORD0) * material.tint;
// CHECK-NEXT: SV_Target2 = vs_NORMAL0.xy;
// CHECK-NEXT: SV_Target1 = vs_ID0;
// CHECK-NEXT: }

// BYNAME: {{^}}in vec2 vs_TEXCOORD0;
// BYNAME: layout(location = 0) out vec4 SV_Target0;

// VULKAN: texture(sampler2D(albedo, trilinear), vs_TEXCOORD0)

// ES: #version 300 es
// ES: precision highp float;
// ES-NEXT: precision highp int;
// ES: uniform highp sampler2D albedo;
// ES: {{^}}flat in uint vs_ID0;
