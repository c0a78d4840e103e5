// The pixel shader reads a part of the outputs, in another order.
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t --reference reference
cbuffer Frame : register(b0) { float4x4 view; };
struct Varyings { float4 position : SV_Position; float3 normal : NORMAL; float2 uv : TEXCOORD0; float4 color : COLOR; };
Varyings vs(float4 p : POSITION, float3 n : NORMAL, float2 uv : TEXCOORD0, float4 c : COLOR) {
  Varyings v;
  v.position = mul(p, view);
  v.normal = n;
  v.uv = uv;
  v.color = c;
  return v;
}
struct Read { float4 color : COLOR; float2 uv : TEXCOORD0; float4 position : SV_Position; };
Read reference(float4 p : POSITION, float3 n : NORMAL, float2 uv : TEXCOORD0, float4 c : COLOR) {
  Read v;
  v.position = mul(p, view);
  v.uv = uv;
  v.color = c;
  return v;
}
float4 ps(float4 color : COLOR, float2 uv : TEXCOORD0) : SV_Target { return color * uv.x; }
