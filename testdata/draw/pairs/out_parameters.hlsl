// Outputs as parameters, in another order than the pixel shader's struct.
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t --reference reference
void vs(float4 p : POSITION, float4 c : COLOR, out float4 color : COLOR, out float2 uv : TEXCOORD3, out float4 position : SV_Position) {
  position = p;
  color = c;
  uv = c.zw * p.xy;
}
void reference(float4 p : POSITION, float4 c : COLOR, out float4 position : SV_Position, out float2 uv : TEXCOORD3, out float4 color : COLOR) {
  position = p;
  color = c;
  uv = c.zw * p.xy;
}
struct Read { float4 position : SV_Position; float2 uv : TEXCOORD3; float4 color : COLOR; };
float4 ps(Read v) : SV_Target { return v.color + v.uv.xyyx; }
