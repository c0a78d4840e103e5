// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// How much of the sky a pixel sees, from the depth around it.
// clipc -T ps_5_0
Texture2D<float> depth_buffer : register(t0);
Texture2D<float2> noise : register(t1);
SamplerState point_clamp : register(s0);
SamplerState point_wrap : register(s1);

cbuffer View : register(b0) {
  float4 projection;  // x and y scales, and what makes view depth of the buffer's: z = w / (d - z)
  float2 size;
  float radius;
  float power;
};

static const int kSamples = 12;
static const float3 kKernel[kSamples] = {
    float3(0.355, -0.271, 0.124), float3(-0.062, 0.118, 0.051),  float3(0.211, 0.402, 0.310),
    float3(-0.478, 0.033, 0.217), float3(0.087, -0.092, 0.044),  float3(-0.253, -0.338, 0.441),
    float3(0.514, 0.227, 0.402),  float3(-0.133, 0.547, 0.288),  float3(0.029, -0.618, 0.340),
    float3(-0.391, 0.410, 0.521), float3(0.660, -0.148, 0.287),  float3(0.012, 0.009, 0.930)};

float ViewDepth(float2 uv) { return projection.w / (depth_buffer.SampleLevel(point_clamp, uv, 0) - projection.z); }

float3 ViewPosition(float2 uv) {
  float z = ViewDepth(uv);
  return float3((uv * 2 - 1) * float2(1, -1) / projection.xy * z, z);
}

float2 Uv(float3 view) { return view.xy * projection.xy / view.z * float2(0.5, -0.5) + 0.5; }

float main(float4 pixel : SV_Position, float2 uv : TEXCOORD0) : SV_Target {
  float3 p = ViewPosition(uv);
  float3 n = normalize(cross(ddx(p), ddy(p)));
  float2 spin = noise.SampleLevel(point_wrap, pixel.xy / 4, 0) * 2 - 1;
  float3 t = normalize(float3(spin, 0) - n * dot(float3(spin, 0), n));
  float3x3 frame = float3x3(t, cross(n, t), n);
  float hidden = 0;
  [loop]
  for (int i = 0; i < kSamples; i++) {
    float3 s = p + mul(kKernel[i], frame) * radius;
    float z = ViewDepth(Uv(s));
    float near = smoothstep(0, 1, radius / max(abs(p.z - z), 1e-4));
    hidden += (z <= s.z - 0.02 ? 1 : 0) * near;
  }
  return pow(saturate(1 - hidden / kSamples), power);
}
