// Direct3D 9: the quad is clockwise, which CCW, the default, keeps.
// DRAW Cull Clockwise
// PIXEL 8 8 = 0 0 0 0
// DRAW Cull Counter
// PIXEL 8 8 = 255 255 0 255
// DRAW Cull Turned
// PIXEL 8 8 = 0 0 255 255
float4 VS(float4 p : POSITION, uniform float x) : POSITION { p.x *= x; return p; }
float4 PS(float face : VFACE) : COLOR { return face > 0 ? float4(1, 1, 0, 1) : float4(0, 0, 1, 1); }
technique Cull {
  pass Clockwise { CullMode = CW; VertexShader = compile vs_3_0 VS(1); PixelShader = compile ps_3_0 PS(); }
  pass Counter { CullMode = CCW; VertexShader = compile vs_3_0 VS(1); PixelShader = compile ps_3_0 PS(); }
  pass Turned { CullMode = None; VertexShader = compile vs_3_0 VS(-1); PixelShader = compile ps_3_0 PS(); }
}
