// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// What is seen through a portal: its four edges and its own plane.
// clipc -T vs_5_1
struct View {
  float4x4 view_projection;
  float4 edges[4];
  float4 portal;
};
ConstantBuffer<View> view : register(b0);

cbuffer Object : register(b1) {
  row_major float3x4 world;
};

[clipplanes(view.edges[0], view.edges[1], view.edges[2], view.edges[3], view.portal)]
float4 main(float3 position : POSITION, float4 color : COLOR, out float4 out_color : COLOR) : SV_Position {
  out_color = color;
  float3 world_position = mul(world, float4(position, 1));
  return mul(float4(world_position, 1), view.view_projection);
}
