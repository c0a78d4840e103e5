// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The mirrored world above the water: one plane cuts away what lies below the surface.
// clipc -T vs_5_0
cbuffer Camera : register(b0) {
  float4x4 view_projection;
  float3 eye;
  float time;
};
cbuffer Object : register(b1) {
  float4x4 world;
  float4 tint;
};
cbuffer Clip : register(b2) {
  float4 water_plane;
};

struct Vertex {
  float3 position : POSITION;
  float3 normal : NORMAL;
  float2 uv : TEXCOORD0;
};
struct Varyings {
  float4 position : SV_Position;
  float3 normal : NORMAL;
  float3 to_eye : TEXCOORD1;
  float2 uv : TEXCOORD0;
};

[clipplanes(water_plane)]
Varyings main(Vertex v) {
  float4 world_position = mul(float4(v.position, 1), world);
  world_position.y = -world_position.y;

  Varyings o;
  o.position = mul(world_position, view_projection);
  o.normal = normalize(mul(v.normal, (float3x3)world)) * float3(1, -1, 1);
  o.to_eye = eye - world_position.xyz;
  o.uv = v.uv + float2(0.02 * sin(time), 0);
  return o;
}
