#define OSIER_SM 40
#if (OSIER_SM >= 40)
#define OSIER_UNIFORM_SAMPLER2D(tex, regist) uniform Texture2D texture_##tex : register(T##regist); uniform SamplerState tex : register(S##regist)
#define OSIER_UNIFORM_SAMPLERCUBE(tex, regist) uniform TextureCube texture_##tex : register(T##regist); uniform SamplerState tex : register(S##regist)
#define OSIER_TEX2D(tex, coords) texture_##tex.Sample(tex, coords)
#define OSIER_TEX2DLOD(tex, coords) texture_##tex.SampleLevel(tex, (coords).xy, (coords).w)
#define OSIER_POSITION SV_Position
#define OSIER_TARGET0 SV_Target0
#endif
struct Conn { float4 hpos : OSIER_POSITION; float2 out_texCoord : TEXCOORD0; float3x3 viewToTangent : TEXCOORD1; float4 wsEyeRay : TEXCOORD4; };
struct Vert { float3 position : POSITION; float3 normal : NORMAL; float3 T : TANGENT; float2 texCoord : TEXCOORD0; float tangentW : TEXCOORD3; };
OSIER_UNIFORM_SAMPLER2D(diffuseMap, 0);
OSIER_UNIFORM_SAMPLER2D(bumpMap, 1);
OSIER_UNIFORM_SAMPLERCUBE(cubeMap, 2);
uniform float4x4 modelview : register(C0);
uniform float4x4 objTrans : register(C4);
uniform float3 eyePosWorld : register(C8);
uniform float4 diffuseMaterialColor : register(C9);
uniform float alphaTestValue : register(C10);
Conn vert(Vert IN) {
  Conn OUT;
  OUT.hpos = mul(modelview, float4(IN.position.xyz, 1));
  OUT.out_texCoord = (float2)IN.texCoord;
  float3x3 objToTangentSpace;
  objToTangentSpace[0] = IN.T;
  objToTangentSpace[1] = cross(IN.T, normalize(IN.normal)) * IN.tangentW;
  objToTangentSpace[2] = normalize(IN.normal);
  OUT.viewToTangent = mul(objToTangentSpace, transpose((float3x3)objTrans));
  OUT.wsEyeRay = float4(mul(objTrans, float4(IN.position, 1)).xyz - eyePosWorld, 0);
  return OUT;
}
struct Fragout { float4 col : OSIER_TARGET0; };
Fragout frag(Conn IN) {
  Fragout OUT;
  float4 diffuseColor = OSIER_TEX2D(diffuseMap, IN.out_texCoord);
  OUT.col = diffuseColor * diffuseMaterialColor;
#if ALPHA_TEST
  clip(OUT.col.a - alphaTestValue);
#endif
#if BUMP
  float4 bumpNormal = float4(OSIER_TEX2D(bumpMap, IN.out_texCoord).xyz * 2.0 - 1.0, 0.0);
  half3 gbNormal = (half3)mul(bumpNormal.xyz, IN.viewToTangent);
  OUT.col.rgb *= texture_cubeMap.SampleLevel(cubeMap, reflect(IN.wsEyeRay.xyz, gbNormal), 2).rgb;
#endif
  return OUT;
}
