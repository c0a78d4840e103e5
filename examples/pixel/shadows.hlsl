// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The sun's light through four cascades of shadow maps, each filtered over nine texels.
// clipc -T ps_5_0
#include "lighting.hlsli"

#define CASCADES 4
#define RADIUS 1

Texture2DArray shadow_maps : register(t0);
Texture2D albedo_map : register(t1);
SamplerComparisonState less : register(s0);
SamplerState linear_wrap : register(s1);

cbuffer Sun : register(b0) {
  row_major float4x4 to_cascade[CASCADES];
  float4 cascade_ends;
  float3 sun_direction;
  float bias;
  float3 sun_colour;
  float texel;
  float3 sky_colour;
  float fog_density;
};

struct Input {
  float4 position : SV_Position;
  float3 world : TEXCOORD0;
  float depth : TEXCOORD1;
  float3 normal : TEXCOORD2;
  float2 uv : TEXCOORD3;
};

int CascadeOf(float depth) {
  int cascade = 0;
  [unroll]
  for (int i = 0; i < CASCADES - 1; i++) {
    if (depth > cascade_ends[i]) cascade = i + 1;
  }
  return cascade;
}

float Lit(float3 world, float3 normal, int cascade) {
  float4 p = mul(float4(world + normal * bias * (cascade + 1), 1), to_cascade[cascade]);
  float2 uv = p.xy * float2(0.5, -0.5) + 0.5;
  if (any(uv < 0) || any(uv > 1)) return 1;
  float lit = 0;
  for (int y = -RADIUS; y <= RADIUS; y++) {
    for (int x = -RADIUS; x <= RADIUS; x++) {
      lit += shadow_maps.SampleCmpLevelZero(less, float3(uv + float2(x, y) * texel, cascade), p.z - bias);
    }
  }
  return lit / ((2 * RADIUS + 1) * (2 * RADIUS + 1));
}

float4 main(Input input) : SV_Target0 {
  float3 n = normalize(input.normal);
  int cascade = CascadeOf(input.depth);
  float lit = Lit(input.world, n, cascade);
  float edge = saturate((cascade_ends[cascade] - input.depth) * 0.2);
  if (edge < 1 && cascade + 1 < CASCADES) {
    lit = lerp(Lit(input.world, n, cascade + 1), lit, edge);
  }
  float3 albedo = ToLinear(albedo_map.Sample(linear_wrap, input.uv).rgb);
  float3 light = sun_colour * (lit * saturate(dot(n, -sun_direction))) + sky_colour * (n.y * 0.5 + 0.5);
  return float4(Fog(albedo * light, sky_colour, input.depth, fog_density), 1);
}
