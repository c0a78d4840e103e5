// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Objects around a lake. The reflection draws only what is above the water: the application hands the water's surface
// over as a plane in clip space, and the shader need not know how it is clipped by.
cbuffer Object : register(b0) {
  float4x4 world_view_projection;
  float4x4 world;
};

cbuffer Scene : register(b1) {
  float4 water_plane;
};

struct Output {
  float4 position : SV_Position;
  float3 normal : NORMAL;
  float3 world_position : TEXCOORD0;
};

[clipplanes(water_plane)]
Output main(float3 position : POSITION, float3 normal : NORMAL) {
  Output output;
  output.position = mul(float4(position, 1), world_view_projection);
  output.normal = mul(normal, (float3x3)world);
  output.world_position = mul(float4(position, 1), world).xyz;
  return output;
}
