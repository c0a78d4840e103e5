// A constant buffer that both read, of which each reads other members.
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t
cbuffer Frame : register(b2) { float4x4 view; float4 tint; row_major float4x4 color; float3 bias; float scale; };
struct Varyings { float4 position : SV_Position; float4 uv : TEXCOORD0; };
Varyings vs(float4 p : POSITION, float4 uv : TEXCOORD0) {
  Varyings v;
  v.position = mul(p, view) * scale;
  v.uv = mul(uv, color) * tint;
  return v;
}
float4 ps(Varyings v) : SV_Target { return mul(color, v.uv) + float4(bias, scale); }
