// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Shadow cascades: every object goes to the cascade that its instance data names.
// clipc -T vs_5_0
#pragma pack_matrix(row_major)
namespace shadows {
struct Cascade {
  float4x4 view_projection;
  float2 scale;
  float bias;
};
}

cbuffer Shadows : register(b3) {
  shadows::Cascade cascades[4];
  float4 split;
};

float4 main(float4 position : POSITION, float4 row0 : INSTANCE0, float4 row1 : INSTANCE1, float4 row2 : INSTANCE2,
            nointerpolation uint cascade : CASCADE, out nointerpolation uint slice : SLICE) : SV_Position {
  slice = min(cascade, 3u);
  const shadows::Cascade c = cascades[slice];
  float3 world = float3(dot(row0, position), dot(row1, position), dot(row2, position));
  float4 clip = mul(float4(world, 1), c.view_projection);
  clip.xy *= c.scale;
  clip.z += c.bias * clip.w;
  return clip;
}
