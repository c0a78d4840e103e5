// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The second pass of deferred shading: the lights of a tile, on what the first pass has written.
// clipc -T ps_5_0
#include "lighting.hlsli"

Texture2D<float4> albedo_and_metalness : register(t0);
Texture2D<float4> normal_and_roughness : register(t1);
Texture2D<float> depth_buffer : register(t2);
StructuredBuffer<Light> lights : register(t3);
Buffer<uint> light_indices : register(t4);
Texture2D<uint2> tiles : register(t5);

cbuffer View : register(b0) {
  float4x4 clip_to_world;
  float3 eye;
  float pad;
  float2 size;
};

static const uint kTile = 16;

float4 main(float4 pixel : SV_Position) : SV_Target {
  int3 texel = int3(pixel.xy, 0);
  float depth = depth_buffer.Load(texel);
  if (depth >= 1) discard;

  float2 ndc = (pixel.xy / size) * float2(2, -2) + float2(-1, 1);
  float4 world = mul(float4(ndc, depth, 1), clip_to_world);
  float4 g0 = albedo_and_metalness.Load(texel);
  float4 g1 = normal_and_roughness.Load(texel);

  Surface surface = (Surface)0;
  surface.position = world.xyz / world.w;
  surface.albedo = g0.rgb;
  surface.metalness = g0.a;
  surface.normal = DecodeNormal(g1.xy);
  surface.roughness = max(g1.z, 0.05);
  surface.occlusion = g1.w;

  float3 view = normalize(eye - surface.position);
  float3 colour = 0.03 * surface.albedo * surface.occlusion;
  uint2 tile = tiles.Load(int3(uint2(pixel.xy) / kTile, 0));
  for (uint i = 0; i < tile.y; ++i) {
    Light light = lights[light_indices[tile.x + i]];
    if (light.kind > LIGHT_DIRECTIONAL) continue;
    colour += Shade(surface, light, view);
  }
  return float4(colour, 1);
}
