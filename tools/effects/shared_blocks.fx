// Direct3D 9: parameters that only some passes read: each program has a buffer of its own for $Globals.
// SET A = 1 0 0 1
// SET B = 0 1 0 1
// DRAW Several OnlyA
// PIXEL 8 8 = 255 0 0 255
// DRAW Several OnlyB
// PIXEL 8 8 = 0 255 0 255
// DRAW Several Both
// PIXEL 8 8 = 255 255 0 255
// SET A = 0 0 1 1
// DRAW Several Both
// PIXEL 8 8 = 0 255 255 255
shared float4 A;
shared float4 B;
float4 VS(float4 p : POSITION) : POSITION { return p; }
float4 PSA() : COLOR { return A; }
float4 PSB() : COLOR { return B; }
float4 PSBoth() : COLOR { return float4(A.rgb + B.rgb, 1); }
technique Several {
  pass OnlyA { ZEnable = false; VertexShader = compile vs_2_0 VS(); PixelShader = compile ps_2_0 PSA(); }
  pass OnlyB { ZEnable = false; VertexShader = compile vs_2_0 VS(); PixelShader = compile ps_2_0 PSB(); }
  pass Both { ZEnable = false; VertexShader = compile vs_2_0 VS(); PixelShader = compile ps_2_0 PSBoth(); }
}
