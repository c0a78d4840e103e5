// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A grid raised by a height map; normals from central differences.
// clipc -T vs_5_0
Texture2D<float> heights : register(t0);
SamplerState linear_clamp : register(s0);

cbuffer Terrain : register(b0) {
  float4x4 view_projection;
  float2 origin;
  float cell;
  float height_scale;
  float2 texel;
  float4 cut;
};

float Height(float2 uv) { return heights.SampleLevel(linear_clamp, uv, 0) * height_scale; }

[clipplanes(cut)]
float4 main(float2 grid : POSITION, out float3 normal : NORMAL, out float2 uv : TEXCOORD) : SV_Position {
  uv = grid * texel;
  float left = Height(uv - float2(texel.x, 0)), right = Height(uv + float2(texel.x, 0));
  float down = Height(uv - float2(0, texel.y)), up = Height(uv + float2(0, texel.y));
  normal = normalize(float3(left - right, 2 * cell, down - up));
  float2 xz = origin + grid * cell;
  return mul(float4(xz.x, Height(uv), xz.y, 1), view_projection);
}
