#if OPENGL
#define SV_POSITION POSITION
#define VS_MODEL vs_3_0
#define PS_MODEL ps_3_0
#define BEGIN_CONSTANTS
#define END_CONSTANTS
#define _vs(r) : register(vs, r)
#define _ps(r) : register(ps, r)
#define _cb(r)
#define DECLARE_TEXTURE(Name, index) texture2D Name; sampler Name##Sampler : register(s##index) = sampler_state { Texture = (Name); };
#define SAMPLE_TEXTURE(Name, texCoord) tex2D(Name##Sampler, texCoord)
#else
#define VS_MODEL vs_4_0
#define PS_MODEL ps_4_0
#define BEGIN_CONSTANTS cbuffer Parameters : register(b0) {
#define END_CONSTANTS };
#define _vs(r)
#define _ps(r)
#define _cb(r) : packoffset(r)
#define DECLARE_TEXTURE(Name, index) Texture2D<float4> Name : register(t##index); sampler Name##Sampler : register(s##index)
#define SAMPLE_TEXTURE(Name, texCoord) Name.Sample(Name##Sampler, texCoord)
#endif
#define TECHNIQUE(name, vsname, psname) technique name { pass { VertexShader = compile VS_MODEL vsname(); PixelShader = compile PS_MODEL psname(); } }
DECLARE_TEXTURE(Texture, 0);
BEGIN_CONSTANTS
  float4 DiffuseColor _vs(c0) _ps(c1) _cb(c0);
  float3 FogColor _ps(c0) _cb(c1);
  float4 FogVector _vs(c14) _cb(c2);
  float4x4 WorldViewProj _vs(c15) _cb(c3);
  float4x3 Bones[12] _vs(c26) _cb(c7);
END_CONSTANTS
struct VSInput { float4 Position : POSITION; float3 Normal : NORMAL; float2 TexCoord : TEXCOORD0; float4 Color : COLOR; int4 Indices : BLENDINDICES0; float4 Weights : BLENDWEIGHT0; };
struct VSOutput { float4 PositionPS : SV_POSITION; float4 Diffuse : COLOR0; float4 Specular : COLOR1; float2 TexCoord : TEXCOORD0; };
void Skin(inout VSInput vin, uniform int boneCount) {
  float4x3 skinning = 0;
  [unroll]
  for (int i = 0; i < boneCount; i++) skinning += Bones[vin.Indices[i]] * vin.Weights[i];
  vin.Position.xyz = mul(vin.Position, skinning);
}
VSOutput Shared(VSInput vin) {
  VSOutput vout;
  vout.PositionPS = mul(vin.Position, WorldViewProj);
  vout.Diffuse = vin.Color * DiffuseColor;
  vout.Specular = float4(0, 0, 0, saturate(dot(vin.Position, FogVector)));
  vout.TexCoord = vin.TexCoord;
  return vout;
}
VSOutput VSBasic(VSInput vin) { return Shared(vin); }
VSOutput VSOneBone(VSInput vin) { Skin(vin, 1); return Shared(vin); }
VSOutput VSFourBones(VSInput vin) { Skin(vin, 4); return Shared(vin); }
float4 PSBasic(VSOutput pin) : SV_Target0 { float4 c = SAMPLE_TEXTURE(Texture, pin.TexCoord) * pin.Diffuse; c.rgb = lerp(c.rgb, FogColor * c.a, pin.Specular.w); return c; }
float4 PSNoFog(VSOutput pin) : SV_Target0 { return SAMPLE_TEXTURE(Texture, pin.TexCoord) * pin.Diffuse; }
TECHNIQUE(Basic, VSBasic, PSBasic);
TECHNIQUE(Skinned, VSFourBones, PSNoFog);
