// Constants, and the number of the vertex.
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t
cbuffer Frame : register(b0) { float4 offset; float4x4 view; };
static const float4 kScale = float4(1, 2, 3, 4);
struct Varyings { float4 position : SV_Position; float4 color : COLOR; };
Varyings vs(float4 p : POSITION, float4 c : COLOR, uint id : SV_VertexID) {
  Varyings v;
  v.position = p + offset * 0.1;
  v.color = c * kScale * (1 + (id & 3));
  return v;
}
float4 ps(Varyings v) : SV_Target { return v.color; }
