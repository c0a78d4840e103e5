// Two buffers; the pixel shader reads one that the vertex shader has second.
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t
cbuffer Object : register(b1) { float4x4 world; float4 object_color; };
cbuffer Frame : register(b0) { float4x4 view; float4 light; };
struct Varyings { float4 position : SV_Position; float4 color : COLOR; };
Varyings vs(float4 p : POSITION, float4 c : COLOR) {
  Varyings v;
  v.position = mul(mul(p, world), view);
  v.color = c * light;
  return v;
}
float4 ps(Varyings v) : SV_Target { return v.color * light.wzyx; }
