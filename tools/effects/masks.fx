// Direct3D 9: channels that are written, by names and by number; a constant that blends.
// DRAW Masks Red
// PIXEL 8 8 = 255 0 0 255
// DRAW Masks Blue
// PIXEL 8 8 = 255 0 255 255
// DRAW Masks Factor
// PIXEL 8 8 = 128 64 128 255
float4 VS(float4 p : POSITION) : POSITION { return p; }
float4 PS() : COLOR { return 1; }
float4 Green() : COLOR { return float4(0, 0.5, 0, 1); }
technique Masks {
  pass Red { ColorWriteEnable = RED | ALPHA; VertexShader = compile vs_2_0 VS(); PixelShader = compile ps_2_0 PS(); }
  pass Blue { ColorWriteEnable = 4; VertexShader = compile vs_2_0 VS(); PixelShader = compile ps_2_0 PS(); }
  pass Factor {
    AlphaBlendEnable = true; SrcBlend = BlendFactor; DestBlend = InvBlendFactor; BlendFactor = 0xFF808080;
    VertexShader = compile vs_2_0 VS(); PixelShader = compile ps_2_0 Green();
  }
}
