// X-Ray: screen-space passes by VPOS, constants from macros, a loop that unrolls.
// SET m_scale = 2
// DRAW tonemap
// PIXEL 4 8 = 85 0 0 255
// PIXEL 12 8 = 153 0 0 255
#define WIDTH 16
#define TAPS 3
uniform float m_scale;
float4 vs(float4 p : POSITION) : POSITION { return p; }
float4 ps(float2 pos : VPOS) : COLOR {
  float lum = 0;
  [unroll] for (int i = 0; i < TAPS; i++) lum += pos.x / WIDTH / TAPS;
  lum *= m_scale;
  return float4(lum / (1 + lum), 0, 0, 1);
}
technique tonemap { pass P0 { VertexShader = compile vs_3_0 vs(); PixelShader = compile ps_3_0 ps(); } }
