// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Fur: a triangle becomes a hair that stands on its centre and bends in the wind. A plane cuts the hairs off at the water.
// clipc -T gs_5_0
struct Vertex {
  float3 position : POSITION;
  float3 normal : NORMAL;
};

struct Corner {
  float4 position : SV_Position;
  float along : TEXCOORD0;  // 0 at the root, 1 at the tip
};

cbuffer Frame : register(b0) {
  float4x4 view_projection;
  float4 water_plane;  // in clip space
  float3 wind;
  float length;
};

static const int PARTS = 4;

[clipplanes(water_plane)]
[maxvertexcount(2 * PARTS + 1)]
void main(triangle Vertex v[3], inout TriangleStream<Corner> hair) {
  const float3 root = (v[0].position + v[1].position + v[2].position) / 3;
  const float3 up = normalize(v[0].normal + v[1].normal + v[2].normal);
  const float3 side = 0.1 * (v[1].position - v[0].position);
  Corner corner;
  for (int i = 0; i <= PARTS; ++i) {
    corner.along = float(i) / PARTS;
    const float3 at = root + length * (up * corner.along + wind * corner.along * corner.along);
    const float3 half_width = side * (1 - corner.along);
    if (i < PARTS) {
      corner.position = mul(float4(at - half_width, 1), view_projection);
      hair.Append(corner);
    }
    corner.position = mul(float4(at + half_width, 1), view_projection);
    hair.Append(corner);
  }
}
