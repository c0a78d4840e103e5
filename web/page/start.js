// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
export const START = `// Turn the plane below, or change something here.
// clipc -T vs_5_0
cbuffer Camera : register(b0) {
  float4x4 view_projection;
};
cbuffer Object : register(b1) {
  float4x4 world;
  float4 plane;
};

struct Vertex {
  float3 position : POSITION;
  float3 normal : NORMAL;
};
struct Varyings {
  float4 position : SV_Position;
  float3 normal : NORMAL;
};

[clipplanes(plane)]
Varyings main(Vertex v) {
  float4 world_position = mul(float4(v.position, 1), world);
  Varyings o;
  o.position = mul(world_position, view_projection);
  o.normal = mul(v.normal, (float3x3)world);
  return o;
}
`;
