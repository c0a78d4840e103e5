// The same struct on both sides.
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t
cbuffer Frame : register(b0) { float4x4 view; float4 tint; };
struct Varyings { float4 position : SV_Position; float3 normal : NORMAL; float2 uv : TEXCOORD0; };
Varyings vs(float4 p : POSITION, float3 n : NORMAL, float2 uv : TEXCOORD0) {
  Varyings v;
  v.position = mul(p, view);
  v.normal = n;
  v.uv = uv;
  return v;
}
float4 ps(Varyings v) : SV_Target { return float4(v.normal * v.uv.x, v.uv.y) + tint; }
