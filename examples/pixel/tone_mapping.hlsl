// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// From light to the screen: exposure, bloom, a filmic curve, a table of colours, grain.
// clipc -T ps_4_0
#include "lighting.hlsli"

#define CURVE 1

Texture2D scene : register(t0);
Texture2D bloom : register(t1);
Texture3D grading : register(t2);
SamplerState linear_clamp : register(s0);

cbuffer Grading : register(b0) {
  float exposure;
  float bloom_strength;
  float vignette;
  float grain;
  float3 lift;
  float time;
  float3 gain;
  float saturation;
};

float3 Reinhard(float3 x) { return x / (1 + Luminance(x)); }

float3 Filmic(float3 x) {
  const float a = 2.51, b = 0.03, c = 2.43, d = 0.59, e = 0.14;
  return saturate((x * (a * x + b)) / (x * (c * x + d) + e));
}

float Noise(float2 uv) { return frac(sin(dot(uv, float2(12.9898, 78.233)) + time) * 43758.5453); }

float4 main(float4 position : SV_Position, float2 uv : TEXCOORD) : SV_Target {
  float3 colour = scene.Sample(linear_clamp, uv).rgb;
  colour += bloom.Sample(linear_clamp, uv).rgb * bloom_strength;
  float2 centred = uv - 0.5;
  colour *= exposure * (1 - vignette * smoothstep(0.2, 0.9, length(centred) * 1.414));
#if CURVE == 0
  colour = Reinhard(colour);
#elif CURVE == 1
  colour = Filmic(colour);
#else
  colour = 1 - exp(-colour);
#endif
  colour = lerp(Luminance(colour), colour, saturation);
  colour = pow(max(colour * gain + lift, 0), 1.0 / 1.1);
  colour = ToSrgb(colour);
  colour = grading.SampleLevel(linear_clamp, colour * (15.0 / 16) + 0.5 / 16, 0).rgb;
  return float4(colour + (Noise(uv) - 0.5) * grain, Luminance(colour));
}
