// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Direct3D 9's way to draw water: two moving normal maps, a mirrored image, a depth that fades.
// clipc -T ps_3_0
sampler2D waves : register(s0);
sampler2D mirrored : register(s1);
sampler2D below : register(s2);
samplerCUBE sky : register(s3);

float4 time : register(c0);
float4 deep_colour : register(c1);
float4 sun : register(c2);
float4 eye : register(c3);
float3 fog_colour : register(c4);
float2 fog : register(c5);

struct Input {
  float4 projected : TEXCOORD0;
  float3 world : TEXCOORD1;
  float4 uv : TEXCOORD2;
  float depth : TEXCOORD3;
  half4 colour : COLOR0;
};

half3 Wave(float2 uv) { return tex2D(waves, uv).xyz * 2 - 1; }

half4 main(Input i, float facing : VFACE) : COLOR {
  half3 n = Wave(i.uv.xy + time.xx) + Wave(i.uv.zw - time.xy * 0.7);
  n = normalize(half3(n.xy * 0.5, n.z)).xzy;
  if (facing < 0) n = -n;
  float3 v = normalize(eye.xyz - i.world);
  float fresnel = saturate(0.02 + 0.98 * pow(1 - saturate(dot(v, n)), 5));

  float4 shifted = i.projected;
  shifted.xy += n.xz * (0.1 * shifted.w);
  half3 up = tex2Dproj(mirrored, shifted).rgb;
  half3 down = tex2Dproj(below, shifted).rgb;
  down = lerp(deep_colour.rgb, down, saturate(exp(-i.depth * deep_colour.a)));
  float glint = pow(saturate(dot(reflect(-v, n), sun.xyz)), 256) * sun.w;
  half3 c = lerp(down, up, fresnel) + glint + texCUBE(sky, reflect(-v, n)).rgb * 0.1;
  c = lerp(fog_colour, c, saturate((fog.y - length(eye.xyz - i.world)) / (fog.y - fog.x)));
  return half4(c * i.colour.rgb, i.colour.a);
}
