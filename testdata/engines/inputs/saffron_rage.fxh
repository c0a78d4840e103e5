#define BeginSampler(samplerType, textureName, samplerName, resourceName) texture textureName <
#define ContinueSampler(samplerType, textureName, samplerName, resourceName) >; samplerType samplerName = sampler_state { Texture = <textureName>;
#define EndSampler }
#define BeginConstants(name, slot) cbuffer name : register(b##slot) {
#define EndConstants };
#define SHARED shared
#define CONCAT_(a, b) a##b
#define CONCAT(a, b) CONCAT_(a, b)
#define SKIN_SUFFIX Skinned
#define ENTRY(name) CONCAT(name, SKIN_SUFFIX)
BeginSampler(sampler2D, diffuseTexture, DiffuseSampler, DiffuseTex)
  string UIName = "Diffuse Texture"; string TextureOutputFormats = "PC=DXT1";
ContinueSampler(sampler2D, diffuseTexture, DiffuseSampler, DiffuseTex)
  AddressU = WRAP; AddressV = WRAP; MIPFILTER = LINEAR; MipMapLodBias = 0;
EndSampler;
BeginSampler(samplerCUBE, envTexture, EnvSampler, EnvTex)
ContinueSampler(samplerCUBE, envTexture, EnvSampler, EnvTex)
EndSampler;
SHARED float4x4 gWorld : World;
SHARED float4x4 gWorldViewProj : WorldViewProjection;
SHARED row_major float3x4 gBoneMtx[32] : WorldMatrixArray : register(c64);
float bumpiness : Bumpiness <string UIWidget = "slider"; float UIMin = 0.0; float UIMax = 200.0; float UIStep = .01; string UIName = "Bumpiness";> = 1.0;
float4 materialColor[2] = { {1, 1, 1, 1}, {.5, .5, .5, 1} };
struct rageVertexInput { float3 pos : POSITION0; float4 weight : BLENDWEIGHT; float4 blendindices : BLENDINDICES; float2 texCoord0 : TEXCOORD0; float3 normal : NORMAL; float4 diffuse : COLOR0; };
struct vertexOutput { float4 pos : POSITION; float2 texCoord : TEXCOORD0; float3 worldNormal : TEXCOORD1; float4 color0 : COLOR0; };
float3 rageSkinTransform(float3 pos, float3x4 mtx) { return mul(mtx, float4(pos, 1)); }
vertexOutput VS_Transform(rageVertexInput IN) {
  vertexOutput OUT;
  OUT.pos = (float4)mul(float4(IN.pos, 1), gWorldViewProj);
  OUT.texCoord = IN.texCoord0;
  OUT.worldNormal = normalize(mul(IN.normal, (float3x3)gWorld));
  OUT.color0 = IN.diffuse * materialColor[0];
  return OUT;
}
vertexOutput ENTRY(VS_Transform)(rageVertexInput IN) {
  int4 i = D3DCOLORtoUBYTE4(IN.blendindices);
  IN.pos = rageSkinTransform(IN.pos, gBoneMtx[i.z]) * IN.weight.x + rageSkinTransform(IN.pos, gBoneMtx[i.y]) * IN.weight.y;
  return VS_Transform(IN);
}
float4 PS_Textured(vertexOutput IN) : COLOR { return tex2D(DiffuseSampler, IN.texCoord) * IN.color0; }
float4 PS_Env(vertexOutput IN) : COLOR { return PS_Textured(IN) + texCUBE(EnvSampler, IN.worldNormal * bumpiness) * materialColor[1]; }
technique draw { pass p0 { AlphaBlendEnable = true; VertexShader = compile VERTEXSHADER VS_Transform(); PixelShader = compile PIXELSHADER PS_Textured(); } }
