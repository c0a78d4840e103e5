// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A metal or a dielectric with a normal map, under a few lights and an environment.
// clipc -T ps_5_0
#include "lighting.hlsli"

#define LIGHT_COUNT 4
#define HAS_NORMAL_MAP 1
#define HAS_EMISSION 1

cbuffer Frame : register(b0) {
  float3 eye;
  float exposure;
  Light lights[LIGHT_COUNT];
  float4 ambient[9];
};

cbuffer Material : register(b1) {
  float4 base_colour;
  float3 emission;
  float alpha_cutoff;
  float2 roughness_metalness;
  float2 tiling;
};

Texture2D albedo_map : register(t0);
Texture2D normal_map : register(t1);
Texture2D<float3> surface_map : register(t2);
TextureCube environment : register(t3);
Texture2D<float3> emission_map : register(t4);
SamplerState trilinear : register(s0);

struct Input {
  float4 position : SV_Position;
  float3 world : POSITION0;
  float3 normal : NORMAL;
  float4 tangent : TANGENT;
  float2 uv : TEXCOORD0;
  bool is_front : SV_IsFrontFace;
};

float3 NormalOf(Input input, float2 uv) {
  float3 n = normalize(input.is_front ? input.normal : -input.normal);
#if HAS_NORMAL_MAP
  float3 t = normalize(input.tangent.xyz - n * dot(n, input.tangent.xyz));
  float3 b = cross(n, t) * input.tangent.w;
  float3 texel;
  texel.xy = normal_map.Sample(trilinear, uv).xy * 2 - 1;
  texel.z = sqrt(saturate(1 - dot(texel.xy, texel.xy)));
  return normalize(mul(texel, float3x3(t, b, n)));
#else
  return n;
#endif
}

float4 main(Input input) : SV_Target {
  float2 uv = input.uv * tiling;
  float4 texel = albedo_map.Sample(trilinear, uv) * base_colour;
  clip(texel.a - alpha_cutoff);

  float3 map = surface_map.Sample(trilinear, uv);
  Surface surface;
  surface.albedo = texel.rgb;
  surface.occlusion = map.r;
  surface.roughness = clamp(map.g * roughness_metalness.x, 0.045, 1);
  surface.metalness = saturate(map.b * roughness_metalness.y);
  surface.normal = NormalOf(input, uv);
  surface.position = input.world;

  float3 view = normalize(eye - input.world);
  float3 colour = 0;
  [unroll]
  for (int i = 0; i < LIGHT_COUNT; ++i) colour += Shade(surface, lights[i], view);

  float3 diffuse = surface.albedo * (1 - surface.metalness) * Ambient(ambient, surface.normal);
  float3 f0 = lerp(0.04, surface.albedo, surface.metalness);
  float3 mirrored = environment.SampleLevel(trilinear, reflect(-view, surface.normal), surface.roughness * 7).rgb;
  float3 fresnel = FresnelSchlick(f0, saturate(dot(surface.normal, view)));
  colour += (diffuse + mirrored * fresnel) * surface.occlusion;
#if HAS_EMISSION
  colour += emission * emission_map.Sample(trilinear, uv);
#endif
  return float4(colour * exposure, texel.a);
}
