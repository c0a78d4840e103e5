// Outputs that nothing reads are left out, and what only they need.
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t --reference reference
cbuffer Frame : register(b0) { float4x4 view; };
cbuffer Unread : register(b1) { float4x4 other; };
struct Varyings { float4 position : SV_Position; float4 unread : UNREAD; float4 color : COLOR; };
Varyings vs(float4 p : POSITION, float4 c : COLOR) {
  Varyings v;
  v.position = mul(p, view);
  v.unread = mul(c, other);
  v.color = c;
  return v;
}
void reference(float4 p : POSITION, float4 c : COLOR, out float4 color : COLOR, out float4 position : SV_Position) {
  position = mul(p, view);
  color = c;
}
float4 ps(float4 color : COLOR) : SV_Target { return color.wzyx; }
