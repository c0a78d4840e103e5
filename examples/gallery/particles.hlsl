// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Camera-facing quads, read from a buffer of particles.
// clipc -T vs_5_0
struct Particle {
  float3 position;
  float size;
  float4 color;
};
StructuredBuffer<Particle> particles : register(t0);

cbuffer Camera : register(b0) {
  float4x4 view;
  float4x4 projection;
};

struct Varyings {
  float4 position : SV_Position;
  float4 color : COLOR;
  float2 uv : TEXCOORD;
};

Varyings main(uint id : SV_VertexID) {
  Particle p = particles[id / 6];
  uint corner = id % 6;
  float2 uv = float2(corner == 1 || corner == 2 || corner == 4, corner == 2 || corner >= 4);
  float4 view_position = mul(float4(p.position, 1), view);
  view_position.xy += (uv * 2 - 1) * p.size;

  Varyings o = (Varyings)0;
  o.position = mul(view_position, projection);
  o.color = p.color;
  o.uv = uv;
  return o;
}
