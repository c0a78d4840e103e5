// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Each triangle is drawn to all six faces of a cube map in one pass: the shader chooses the layer.
// clipc -T gs_5_0
struct Vertex {
  float4 world : SV_Position;
  float3 normal : NORMAL;
  float2 uv : TEXCOORD0;
};

struct Corner {
  float4 position : SV_Position;
  float3 normal : NORMAL;
  float2 uv : TEXCOORD0;
  uint face : SV_RenderTargetArrayIndex;
};

cbuffer Faces : register(b0) {
  float4x4 view_projection[6];
};

[instance(6)]
[maxvertexcount(3)]
void main(triangle Vertex corners[3], uint face : SV_GSInstanceID, inout TriangleStream<Corner> stream) {
  [unroll] for (int i = 0; i < 3; ++i) {
    Corner corner;
    corner.position = mul(corners[i].world, view_projection[face]);
    corner.normal = corners[i].normal;
    corner.uv = corners[i].uv;
    corner.face = face;
    stream.Append(corner);
  }
}
