// Direct3D 9: a sampler block with a texture, point samples.
// DRAW Textured
// PIXEL 2 2 = 255 0 0 255
// PIXEL 13 2 = 0 255 0 255
// PIXEL 2 13 = 0 0 255 255
// PIXEL 13 13 = 255 255 255 255
texture Map : DIFFUSEMAP;
sampler2D MapSampler = sampler_state { Texture = <Map>; MinFilter = Point; MagFilter = Point; MipFilter = None; AddressU = Clamp; };
void VS(inout float4 p : POSITION, inout float2 uv : TEXCOORD0) {}
float4 PS(float2 uv : TEXCOORD0) : COLOR0 { return tex2D(MapSampler, uv); }
technique Textured { pass { VertexShader = compile vs_1_1 VS(); PixelShader = compile ps_2_0 PS(); } }
