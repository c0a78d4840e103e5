// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A wall whose stones stand out: a ray that is followed through a height map.
// clipc -T ps_5_0
#include "lighting.hlsli"

Texture2D albedo_map : register(t0);
Texture2D<float4> height_map : register(t1);
SamplerState anisotropic : register(s0);

cbuffer Wall : register(b0) {
  float depth;
  int2 steps;
  float shininess;
  float3 light_colour;
  float4 ambient;
};

struct Input {
  float4 position : SV_Position;
  float2 uv : TEXCOORD0;
  float3 view : TEXCOORD1;
  float3 light : TEXCOORD2;
};

struct Hit {
  float2 uv;
  float height;
};

Hit Follow(float2 uv, float3 view, float2 dx, float2 dy) {
  int count = (int)lerp((float)steps.y, (float)steps.x, saturate(view.z));
  float layer = 1.0 / count;
  float2 step = view.xy / view.z * depth * layer;
  float ray = 1, height = height_map.SampleGrad(anisotropic, uv, dx, dy).a, before = height;
  while (height < ray) {
    before = height - ray;
    ray -= layer;
    uv -= step;
    height = height_map.SampleGrad(anisotropic, uv, dx, dy).a;
  }
  float after = height - ray;
  float weight = after / max(after - before, 1e-5);
  Hit hit = {uv + step * weight, height};
  return hit;
}

float4 main(Input input) : SV_Target {
  float3 view = normalize(input.view), light = normalize(input.light);
  float2 dx = ddx(input.uv), dy = ddy(input.uv);
  Hit hit = Follow(input.uv, view, dx, dy);
  if (any(hit.uv < 0) || any(hit.uv > 1)) discard;
  float3 n = height_map.SampleGrad(anisotropic, hit.uv, dx, dy).xyz * 2 - 1;
  float4 albedo = albedo_map.SampleGrad(anisotropic, hit.uv, dx, dy);
  float3 lit = BlinnPhong(normalize(n), light, view, light_colour, shininess) + ambient.rgb;
  return float4(albedo.rgb * lit, albedo.a);
}
