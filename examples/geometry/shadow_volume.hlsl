// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The sides of a shadow volume: where a triangle faces the light and its neighbour does not, their edge is drawn out to infinity.
// clipc -T gs_4_0
struct Vertex { float4 world : SV_Position; };
struct Corner { float4 position : SV_Position; };

cbuffer Light : register(b0) {
  float4x4 view_projection;
  float3 light;  // a position in the world
};

bool FacesLight(float3 a, float3 b, float3 c) {
  return dot(cross(b - a, c - a), light - a) > 0;
}

Corner At(float3 position, float w) {
  Corner corner = {mul(float4(position, w), view_projection)};
  return corner;
}

void DrawOut(float3 from, float3 to, inout TriangleStream<Corner> volume) {
  volume.Append(At(from, 1));
  volume.Append(At(from - light, 0));
  volume.Append(At(to, 1));
  volume.Append(At(to - light, 0));
  volume.RestartStrip();
}

// Vertices 0, 2 and 4 are the triangle; 1, 3 and 5 are those of its neighbours.
[maxvertexcount(12)]
void main(triangleadj Vertex v[6], inout TriangleStream<Corner> volume) {
  if (!FacesLight(v[0].world.xyz, v[2].world.xyz, v[4].world.xyz)) return;
  for (uint i = 0; i < 6; i += 2) {
    const uint next = (i + 2) % 6;
    if (!FacesLight(v[i].world.xyz, v[i + 1].world.xyz, v[next].world.xyz))
      DrawOut(v[i].world.xyz, v[next].world.xyz, volume);
  }
}
