// An array and a matrix of three rows in a buffer that both read.
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t
cbuffer Lights : register(b0) { float4 lights[4]; row_major float3x4 turn; float4 ambient; };
struct Varyings { float4 position : SV_Position; float4 color : COLOR; };
Varyings vs(float4 p : POSITION, float4 c : COLOR) {
  Varyings v;
  v.position = p;
  v.color = float4(mul(turn, c), 1) * lights[1];
  return v;
}
float4 ps(Varyings v) : SV_Target { return v.color + lights[2] * ambient; }
