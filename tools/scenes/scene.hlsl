// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Objects of one color each, clipped by one plane or by three, which the operands name in an order of their own.
cbuffer Draw : register(b0) {
  row_major float4x4 world_view_projection;
  float4 pixel_offset;  // as fxc adds under feature level 9: Direct3D 9 has its pixels' centers at integers
};

cbuffer Planes : register(b1) {
  float4 planes[3];
};

struct Output {
  float4 position : SV_Position;
  float4 color : COLOR;
};

#if PLANES == 1
[clipplanes(planes[0])]
#else
[clipplanes(planes[2], planes[0], planes[1])]
#endif
Output main(float3 position : POSITION, float4 color : COLOR) {
  Output output;
  output.position = mul(float4(position, 1), world_view_projection);
  output.position.xy += pixel_offset.xy * output.position.ww;
  output.color = color;
  return output;
}
