// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Blades of grass, one instance each, bent by the wind.
// clipc -T vs_5_0
cbuffer Wind {
  float2 direction;
  float strength;
  float time;
};
cbuffer Camera {
  float4x4 view_projection;
};
static const float2 kCorners[4] = {float2(-1, 0), float2(1, 0), float2(-1, 1), float2(1, 1)};

uint Hash(uint x) {
  x ^= x >> 16;
  x *= 0x7feb352du;
  x ^= x >> 15;
  return x;
}
float Random(uint seed) { return (Hash(seed) & 0xffffff) / 16777216.0; }

float4 main(uint corner : SV_VertexID, uint blade : SV_InstanceID, float3 root : ROOT, out half shade : SHADE) : SV_Position {
  float2 offset = kCorners[corner & 3];
  float height = lerp(0.4, 1.0, Random(blade));
  float bend = offset.y * offset.y * strength * sin(time + 6.2831853 * Random(blade + 17));
  float3 position = root + float3(offset.x * 0.02, offset.y * height, 0);
  position.xz += direction * bend;
  shade = 0.5 + 0.5 * offset.y;
  return mul(float4(position, 1), view_projection);
}
