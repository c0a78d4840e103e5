// Direct3D 9: depth tests; `z` is what the technique gives.
// DRAW Depth Near
// DRAW Depth Hidden
// PIXEL 8 8 = 255 0 0 255
// DRAW Depth Behind
// PIXEL 8 8 = 0 0 255 255
// DRAW Depth Always
// PIXEL 8 8 = 255 255 255 255
float4 VS(float4 p : POSITION, uniform float z) : POSITION { p.z = z; return p; }
float4 PS(uniform float4 color) : COLOR { return color; }
technique Depth {
  pass Near { VertexShader = compile vs_2_0 VS(0.5); PixelShader = compile ps_2_0 PS(float4(1, 0, 0, 1)); }
  pass Hidden { ZFunc = Less; VertexShader = compile vs_2_0 VS(0.7); PixelShader = compile ps_2_0 PS(float4(0, 1, 0, 1)); }
  pass Behind { ZFunc = Greater; ZWriteEnable = false; VertexShader = compile vs_2_0 VS(0.7); PixelShader = compile ps_2_0 PS(float4(0, 0, 1, 1)); }
  pass Always { ZEnable = FALSE; VertexShader = compile vs_2_0 VS(0.9); PixelShader = compile ps_2_0 PS(float4(1, 1, 1, 1)); }
}
