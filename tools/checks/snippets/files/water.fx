float4x4 WorldViewProjection : WORLDVIEWPROJECTION;
float4 VS(float4 position : POSITION) : POSITION { return mul(position, WorldViewProjection); }
float4 PS() : COLOR { return 1; }
technique Water {
  pass Draw {
    ZEnable = true;
    VertexShader = compile vs_3_0 VS();
    PixelShader = compile ps_3_0 PS();
  }
}
