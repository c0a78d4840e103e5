// X-Ray: a cut-out by clip, in place of the alpha test, and a second pass where its depth is equal.
// SET m_AlphaRef = 0.5
// DRAW _cut fill
// PIXEL 2 8 = 0 0 0 0
// PIXEL 13 8 = 255 255 255 255
// DRAW _cut light
// PIXEL 2 8 = 0 0 0 0
// PIXEL 13 8 = 128 0 0 255
uniform float m_AlphaRef;
void vs(inout float4 p : POSITION, inout float2 tc : TEXCOORD0) {}
float4 fill(float2 tc : TEXCOORD0) : COLOR { clip(tc.x - m_AlphaRef); return 1; }
float4 light() : COLOR { return float4(0.5, 0, 0, 1); }
technique _cut {
  pass fill { VertexShader = compile vs_3_0 vs(); PixelShader = compile ps_3_0 fill(); }
  pass light { ZWriteEnable = false; ZFunc = Equal; VertexShader = compile vs_3_0 vs(); PixelShader = compile ps_3_0 light(); }
}
