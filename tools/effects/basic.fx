// Direct3D 9: one pass, a matrix by its semantic, a default value.
// SET World = 0.5 0 0 0  0 1 0 0  0 0 1 0  0.5 0 0 1
// DRAW Basic
// PIXEL 12 8 = 51 102 153 255
// PIXEL 3 8 = 0 0 0 0
float4x4 World : WORLD;
float4 Diffuse <string UIName = "Diffuse";> = {0.2, 0.4, 0.6, 1.0};
float4 VS(float4 p : POSITION) : POSITION { return mul(p, World); }
float4 PS() : COLOR { return Diffuse; }
technique Basic { pass P0 { VertexShader = compile vs_2_0 VS(); PixelShader = compile ps_2_0 PS(); } }
