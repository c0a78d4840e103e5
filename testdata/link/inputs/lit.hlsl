// What a vertex shader and a pixel shader share: a block, and outputs that are inputs.
cbuffer PerFrame : register(b0) {
  float4x4 viewProj;
  float4 tint;
  row_major float3x3 turn;
};

struct Vertex {
  float4 position : SV_Position;
  float2 uv : TEXCOORD0;
  float3 normal : NORMAL;
  nointerpolation uint material : MATERIAL;
};

Vertex main(float4 position : POSITION) {
  Vertex vertex;
  vertex.position = mul(position, viewProj);
  vertex.uv = tint.xy;
  vertex.normal = mul(turn, float3(1, 2, 3));
  vertex.material = 7;
  return vertex;
}
