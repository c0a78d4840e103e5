// MonoGame: techniques that macros make, named by what they switch.
// DRAW Effect_Texture
// PIXEL 13 2 = 0 255 0 255
// DRAW Effect
// PIXEL 13 2 = 255 128 64 255
// SET DiffuseColor = 0 0 1 1
// DRAW Effect
// PIXEL 13 2 = 0 0 64 255
#define TECHNIQUE(name, vsname, psname) technique name { pass { VertexShader = compile vs_4_0 vsname(); PixelShader = compile ps_4_0 psname(); } }
#define BEGIN_CONSTANTS cbuffer Parameters : register(b0) {
#define END_CONSTANTS };
#define DECLARE_TEXTURE(Name, index) Texture2D<float4> Name : register(t##index); sampler Name##Sampler : register(s##index)
#define SAMPLE_TEXTURE(Name, at) Name.Sample(Name##Sampler, at)
DECLARE_TEXTURE(Texture, 0);
BEGIN_CONSTANTS
float4 DiffuseColor = float4(1, 1, 1, 1);
END_CONSTANTS
struct Output { float4 Position : SV_Position; float4 Diffuse : COLOR0; float2 TexCoord : TEXCOORD0; };
Output VSBasic(float4 p : SV_Position, float4 c : COLOR, float2 uv : TEXCOORD0) {
  Output o;
  o.Position = p;
  o.Diffuse = c * DiffuseColor;
  o.TexCoord = uv;
  return o;
}
float4 PSBasic(Output i) : SV_Target0 { return i.Diffuse; }
float4 PSTexture(Output i) : SV_Target0 { return SAMPLE_TEXTURE(Texture, float2(step(0.5, i.TexCoord.x), 0)); }
TECHNIQUE(Effect, VSBasic, PSBasic)
TECHNIQUE(Effect_Texture, VSBasic, PSTexture)
