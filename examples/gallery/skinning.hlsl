// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Four bones a vertex.
// clipc -T vs_5_0
#define MAX_BONES 64

cbuffer Skeleton {
  float4x3 bones[MAX_BONES];
};
cbuffer Camera {
  float4x4 view_projection;
};

struct Vertex {
  float3 position : POSITION;
  float3 normal : NORMAL;
  uint4 bones : BLENDINDICES;
  float4 weights : BLENDWEIGHT;
};

void Skin(Vertex v, out float3 position, out float3 normal) {
  position = 0;
  normal = 0;
  [unroll]
  for (int i = 0; i < 4; ++i) {
    float4x3 bone = bones[v.bones[i]];
    position += v.weights[i] * mul(float4(v.position, 1), bone);
    normal += v.weights[i] * mul(v.normal, (float3x3)bone);
  }
}

void main(Vertex v, out float4 position : SV_Position, out float3 normal : NORMAL) {
  float3 skinned;
  Skin(v, skinned, normal);
  position = mul(float4(skinned, 1), view_projection);
  normal = normalize(normal);
}
