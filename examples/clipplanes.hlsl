// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A mesh cut by two planes: the water's surface and a portal's frame. Direct3D clips every triangle where
// dot(position, plane) < 0, so both planes are given in clip space.

// Two matrices, one after the other, leave the vertex in the space between them in float. So that no digits are
// lost far from the world's origin, that space begins at the camera: `world` has the object's place less the
// eye's, subtracted in double, and `view_projection` turns but does not move.
cbuffer Transform : register(b0) {
  float4x4 world;
  float4x4 view_projection;
};

cbuffer ClipPlaneConstantBuffer : register(b1) {
  float4 water_plane;
  float4 portal_plane;
};

struct Vertex {
  float3 position : POSITION;
  float3 normal : NORMAL;
  float2 uv : TEXCOORD0;
};

struct Varyings {
  float4 position : SV_Position;
  float3 normal : NORMAL;
  float2 uv : TEXCOORD0;
};

[clipplanes(water_plane, portal_plane)]
Varyings main(Vertex vertex) {
  Varyings result;
  float4 world_position = mul(float4(vertex.position, 1.0), world);
  result.position = mul(world_position, view_projection);
  result.normal = normalize(mul(vertex.normal, (float3x3)world));
  result.uv = vertex.uv;
  return result;
}
