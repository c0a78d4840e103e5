// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Up to six planes: drawn by the variant with as many as an object needs.
cbuffer Draw : register(b0) {
  row_major float4x4 world_view_projection;
  float4 color;
  float4 planes[6];
};

struct Output {
  float4 position : SV_Position;
  float4 color : COLOR;
};

[clipplanes(planes[0], planes[1], planes[2], planes[3], planes[4], planes[5])]
Output main(float3 position : POSITION, float3 normal : NORMAL) {
  Output output;
  output.position = mul(float4(position, 1), world_view_projection);
  output.color = color * (0.6 + 0.4 * dot(normal, float3(0.36, 0.8, 0.48)));
  return output;
}
