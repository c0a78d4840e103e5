// Direct3D 9: a mask in the stencil buffer, without color, then a draw inside it.
// DRAW Mask Write
// PIXEL 2 8 = 0 0 0 0
// DRAW Mask Inside
// PIXEL 2 8 = 0 255 0 255
// PIXEL 13 8 = 0 0 0 0
// VULKAN Mask Inside = 27:1 28:131 29:127 31:2 35:2
void VS(inout float4 p : POSITION, inout float2 uv : TEXCOORD0) {}
float4 Left(float2 uv : TEXCOORD0) : COLOR { clip(0.5 - uv.x); return 1; }
float4 Green() : COLOR { return float4(0, 1, 0, 1); }
technique Mask {
  pass Write {
    ColorWriteEnable = 0; ZWriteEnable = FALSE;
    StencilEnable = true; StencilFunc = Always; StencilPass = Replace; StencilRef = 3;
    VertexShader = compile vs_2_0 VS(); PixelShader = compile ps_2_0 Left();
  }
  pass Inside {
    StencilEnable = true; StencilFunc = EQUAL; StencilRef = 0x83; StencilMask = 0x7F;
    VertexShader = compile vs_2_0 VS(); PixelShader = compile ps_2_0 Green();
  }
}
