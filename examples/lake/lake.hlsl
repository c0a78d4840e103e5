// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A landscape with a shadow, and a lake that mirrors it: docs/lake.md.
#pragma pack_matrix(row_major)  // in memory as in C++
cbuffer View : register(b0) {
  float4x4 view_projection;
  float4x4 to_light;  // from the world to the clip space of the shadow map
  float4 water;       // in clip space; zeros keep everything
};
cbuffer Object : register(b1) {
  float4x4 world;
  float4 color;
};
Texture2D shadow_map : register(t0);
Texture2D mirror_image : register(t1);
SamplerComparisonState nearer : register(s0);
SamplerState smooth : register(s1);

struct Varyings {
  float4 position : SV_Position;
  float3 normal : NORMAL;
  float4 place : TEXCOORD0;  // in the world
  float4 seen : TEXCOORD1;   // in clip space
};

// From clip space to a texture, whose first row is the upper one.
float2 TexelOf(float4 clip) { return clip.xy / clip.w * float2(0.5, -0.5) + 0.5; }

Varyings Transform(float3 position, float3 normal) {
  Varyings o;
  o.place = mul(float4(position, 1), world);
  o.position = o.seen = mul(o.place, view_projection);
  o.normal = mul(normal, (float3x3)world);
  return o;
}

[clipplanes(water)]
Varyings Land(float3 position : POSITION, float3 normal : NORMAL) { return Transform(position, normal); }

float4 LandColor(Varyings v) : SV_Target {
  float4 light = mul(v.place, to_light);
  float lit = shadow_map.SampleCmp(nearer, TexelOf(light), light.z / light.w - 0.002);
  float slope = abs(dot(normalize(v.normal), normalize(float3(0.5, 0.8, -0.4))));
  return color * (0.35 + 0.65 * lit * slope);
}

Varyings Surface(float3 position : POSITION, float3 normal : NORMAL) { return Transform(position, normal); }

float4 SurfaceColor(Varyings v) : SV_Target {
  return lerp(color, mirror_image.Sample(smooth, TexelOf(v.seen)), 0.7);
}

float4 Depth(float3 position : POSITION) : SV_Position { return mul(mul(float4(position, 1), world), view_projection); }
