// Direct3D 9: a depth bias, a part of the depth range, and one that depends on the slope.
// DRAW Bias Base
// DRAW Bias Behind
// PIXEL 8 8 = 255 0 0 255
// DRAW Bias Before
// PIXEL 8 8 = 0 0 255 255
float4 VS(float4 p : POSITION) : POSITION { return p; }
float4 PS(uniform float3 c) : COLOR { return float4(c, 1); }
technique Bias {
  pass Base { ZFunc = LessEqual; VertexShader = compile vs_2_0 VS(); PixelShader = compile ps_2_0 PS(float3(1, 0, 0)); }
  pass Behind { DepthBias = 0.01; VertexShader = compile vs_2_0 VS(); PixelShader = compile ps_2_0 PS(float3(0, 1, 0)); }
  pass Before { DepthBias = -0.01; SlopeScaleDepthBias = 0.0; ZFunc = Less; VertexShader = compile vs_2_0 VS(); PixelShader = compile ps_2_0 PS(float3(0, 0, 1)); }
}
