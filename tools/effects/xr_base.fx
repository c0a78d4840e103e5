// X-Ray: short names, samplers without blocks, half floats, packed vertex data, entries named main.
// SET m_WVP = 1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1
// SET L_ambient = 0.25 0.25 0.25 0
// DRAW _render
// PIXEL 8 8 = 128 96 80 255
uniform float4x4 m_WVP;
uniform half4 L_ambient;
struct v_in { float4 P : POSITION; float4 N : NORMAL; float4 c : COLOR0; float2 tc : TEXCOORD0; };
struct v2p { float2 tc0 : TEXCOORD0; half3 c0 : COLOR0; float4 hpos : POSITION; };
half3 v_hemi(float3 n) { return half3(0.25, 0.125, 0.0625) * (n.z < 0 ? 1 : 0); }
v2p main_vs(v_in v) {
  v2p O;
  O.hpos = mul(v.P, m_WVP);
  O.tc0 = v.tc;
  O.c0 = L_ambient.rgb + v_hemi(v.N.xyz);
  return O;
}
half4 main_ps(v2p I) : COLOR { return half4(I.c0, 1); }
technique _render { pass _code { VertexShader = compile vs_2_0 main_vs(); PixelShader = compile ps_2_0 main_ps(); } }
