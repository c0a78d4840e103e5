// FNA and XNA: four passes of one technique, each with arguments of its own; render states with numbers.
// DRAW Toon P0
// DRAW Toon P1
// PIXEL 1 8 = 0 0 0 255
// PIXEL 5 8 = 85 85 85 255
// PIXEL 10 8 = 170 170 170 255
// PIXEL 14 8 = 255 255 255 255
void VS(inout float4 p : POSITION0, inout float2 uv : TEXCOORD0) {}
float4 Plain(uniform bool black) : COLOR0 { return black ? float4(0, 0, 0, 1) : float4(1, 1, 1, 1); }
float4 Steps(float2 uv : TEXCOORD0, uniform int levels) : COLOR0 {
  float level = min(floor(uv.x * levels), levels - 1) / (levels - 1);
  return float4(level.xxx, 1);
}
technique Toon {
  pass P0 { ZEnable = 1; ZWriteEnable = 0; VertexShader = compile vs_2_0 VS(); PixelShader = compile ps_2_0 Plain(false); }
  pass P1 { ZEnable = 0; AlphaBlendEnable = 0; VertexShader = compile vs_2_0 VS(); PixelShader = compile ps_2_0 Steps(4); }
}
