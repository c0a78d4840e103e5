// X-Ray: bones as rows of three float4, indexed by a vertex color; one entry with several counts.
// SET m_bones = 1 0 0 0  0 1 0 0  0 0 1 0  0.5 0 0 0.5  0 1 0 0  0 0 1 0
// DRAW _skin _0
// PIXEL 2 8 = 255 255 0 255
// CLEAR
// DRAW _skin _1
// PIXEL 2 8 = 0 0 0 0
// PIXEL 12 8 = 255 255 0 255
uniform float4 m_bones[6];
float4 skin(float4 p, int bone) { return float4(dot(m_bones[bone * 3], p), dot(m_bones[bone * 3 + 1], p), dot(m_bones[bone * 3 + 2], p), 1); }
float4 vs(float4 p : POSITION, uniform int bone) : POSITION { return skin(p, bone); }
float4 ps() : COLOR { return float4(1, 1, 0, 1); }
technique _skin {
  pass _0 { VertexShader = compile vs_1_1 vs(0); PixelShader = compile ps_1_1 ps(); }
  pass _1 { VertexShader = compile vs_1_1 vs(1); PixelShader = compile ps_1_1 ps(); }
}
