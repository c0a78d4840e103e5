// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A teapot and two planes. Which of them clip is the runtime's business: at feature level 9 the device does it.
cbuffer Object : register(b0) {
  float4x4 world_view_projection;
  float4x4 world;
};

cbuffer Clip : register(b1) {
  float4 planes[2];
};

struct Output {
  float4 position : SV_Position;
  float3 normal : NORMAL;
  float3 world_position : TEXCOORD0;
};

[clipplanes(planes[0], planes[1])]
Output main(float3 position : POSITION, float3 normal : NORMAL) {
  Output output;
  output.position = mul(float4(position, 1), world_view_projection);
  output.normal = mul(normal, (float3x3)world);
  output.world_position = mul(float4(position, 1), world).xyz;
  return output;
}
