// Direct3D 9: blending over an earlier pass, and the states of the one not in the other.
// DRAW Blend Opaque
// DRAW Blend Over
// PIXEL 8 8 = 191 0 64 207
// DRAW Blend Add
// PIXEL 8 8 = 191 128 64 255
// DRAW Blend Subtract
// PIXEL 8 8 = 191 0 64 255
float4 VS(float4 p : POSITION) : POSITION { return p; }
float4 PS(uniform float4 color) : COLOR { return color; }
technique Blend {
  pass Opaque { VertexShader = compile vs_2_0 VS(); PixelShader = compile ps_2_0 PS(float4(1, 0, 0, 1)); }
  pass Over {
    AlphaBlendEnable = TRUE; SrcBlend = SRCALPHA; DestBlend = INVSRCALPHA;
    VertexShader = compile vs_2_0 VS(); PixelShader = compile ps_2_0 PS(float4(0, 0, 1, 0.25));
  }
  pass Add {
    AlphaBlendEnable = TRUE; SrcBlend = One; DestBlend = One;
    VertexShader = compile vs_2_0 VS(); PixelShader = compile ps_2_0 PS(float4(0, 0.5, 0, 1));
  }
  pass Subtract {
    AlphaBlendEnable = TRUE; SrcBlend = One; DestBlend = One; BlendOp = RevSubtract;
    SeparateAlphaBlendEnable = true; SrcBlendAlpha = Zero; DestBlendAlpha = One;
    VertexShader = compile vs_2_0 VS(); PixelShader = compile ps_2_0 PS(float4(0, 0.5, 0, 1));
  }
}
