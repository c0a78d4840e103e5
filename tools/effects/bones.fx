// Direct3D 9: an array of shaders, of which the application chooses one; matrices in an array.
// SET Bones = 1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1  1 0 0 0  0 1 0 0  0 0 1 0  2 0 0 1
// DRAW Skinned p0.0
// PIXEL 2 8 = 255 255 255 255
// PIXEL 13 8 = 255 255 255 255
// CLEAR
// DRAW Skinned p0.1
// PIXEL 2 8 = 0 0 0 0
// PIXEL 13 8 = 255 255 255 255
float4x4 Bones[2];
int Current = 0;
float4 VS(float4 p : POSITION, uniform int count) : POSITION {
  float4 sum = 0;
  for (int i = 0; i < count; i++) sum += mul(p, Bones[i]) / count;
  return sum;
}
float4 PS() : COLOR { return 1; }
VertexShader Skins[2] = {compile vs_2_0 VS(1), compile vs_2_0 VS(2)};
technique Skinned { pass p0 { VertexShader = (Skins[Current]); PixelShader = compile ps_2_0 PS(); } }
