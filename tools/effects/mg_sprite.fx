// MonoGame: the sprite effect of its template, with the macros of its two platforms.
// SET MatrixTransform = 1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1
// DRAW SpriteDrawing
// PIXEL 2 2 = 255 0 0 255
// PIXEL 13 13 = 255 128 64 255
#if OPENGL
#define SV_POSITION POSITION
#define VS_SHADERMODEL vs_3_0
#define PS_SHADERMODEL ps_3_0
#else
#define VS_SHADERMODEL vs_4_0_level_9_1
#define PS_SHADERMODEL ps_4_0_level_9_1
#endif
Texture2D SpriteTexture;
sampler2D SpriteTextureSampler = sampler_state { Texture = <SpriteTexture>; MinFilter = Point; MagFilter = Point; };
float4x4 MatrixTransform;
struct VertexShaderOutput { float4 Position : SV_POSITION; float4 Color : COLOR0; float2 TextureCoordinates : TEXCOORD0; };
VertexShaderOutput MainVS(float4 position : POSITION0, float4 color : COLOR0, float2 coordinates : TEXCOORD0) {
  VertexShaderOutput output;
  output.Position = mul(position, MatrixTransform);
  output.Color = color;
  output.TextureCoordinates = coordinates;
  return output;
}
float4 MainPS(VertexShaderOutput input) : COLOR { return tex2D(SpriteTextureSampler, input.TextureCoordinates) * input.Color; }
technique SpriteDrawing { pass P0 { VertexShader = compile VS_SHADERMODEL MainVS(); PixelShader = compile PS_SHADERMODEL MainPS(); } };
