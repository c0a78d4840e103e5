// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Smooths edges of an image along themselves.
// clipc -T ps_5_0
#include "lighting.hlsli"

Texture2D image : register(t0);
SamplerState linear_clamp : register(s0);
float2 texel;
float threshold = 0.125;
float span = 8;

float3 Fetch(float2 uv) { return image.SampleLevel(linear_clamp, uv, 0).rgb; }
float Bright(float2 uv, int2 offset) { return Luminance(image.SampleLevel(linear_clamp, uv, 0, offset).rgb); }

float4 main(noperspective float2 uv : TEXCOORD0) : SV_Target {
  float3 centre = Fetch(uv);
  float m = Luminance(centre);
  float nw = Luminance(Fetch(uv + float2(-1, -1) * texel)), ne = Luminance(Fetch(uv + float2(1, -1) * texel));
  float sw = Luminance(Fetch(uv + float2(-1, 1) * texel)), se = Luminance(Fetch(uv + float2(1, 1) * texel));
  float low = min(m, min(min(nw, ne), min(sw, se)));
  float high = max(m, max(max(nw, ne), max(sw, se)));
  [branch]
  if (high - low < max(0.05, high * threshold)) return float4(centre, 1);

  float2 along = float2((sw + se) - (nw + ne), (nw + sw) - (ne + se));
  float reduce = max((nw + ne + sw + se) * 0.03125, 1.0 / 128);
  float scale = rcp(min(abs(along.x), abs(along.y)) + reduce);
  along = clamp(along * scale, -span, span) * texel;
  float3 narrow = 0.5 * (Fetch(uv + along * (1.0 / 3 - 0.5)) + Fetch(uv + along * (2.0 / 3 - 0.5)));
  float3 wide = narrow * 0.5 + 0.25 * (Fetch(uv - along * 0.5) + Fetch(uv + along * 0.5));
  float bright = Luminance(wide);
  return float4(bright < low || bright > high ? narrow : wide, 1);
}
