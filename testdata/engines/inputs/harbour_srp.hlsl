#define CBUFFER_START(name) cbuffer name {
#define CBUFFER_END };
#define TEXTURE2D(name) Texture2D name
#define SAMPLER(name) SamplerState name
#define TEXTURE2D_PARAM(name, smp) TEXTURE2D(name), SAMPLER(smp)
#define TEXTURE2D_ARGS(name, smp) name, smp
#define SAMPLE_TEXTURE2D(name, smp, uv) name.Sample(smp, uv)
#define SAMPLE_TEXTURE2D_LOD(name, smp, uv, lod) name.SampleLevel(smp, uv, lod)
#define UNITY_MATRIX_M harbour_ObjectToWorld
#define TRANSFORM_TEX(tex, name) ((tex.xy) * name##_ST.xy + name##_ST.zw)
#define HARBOUR_FOG_COORDS(idx) float fogCoord : TEXCOORD##idx;
#define real half
#define real3 half3
#define real4 half4
CBUFFER_START(HarbourPerDraw)
  float4x4 harbour_ObjectToWorld;
  float4x4 harbour_WorldToObject;
  float4 harbour_LODFade;
  real4 harbour_SHAr, harbour_SHAg, harbour_SHAb;
CBUFFER_END
CBUFFER_START(HarbourPerCamera)
  float4x4 harbour_MatrixVP;
  float4 _Time, _ProjectionParams;
CBUFFER_END
CBUFFER_START(HarbourPerMaterial)
  float4 _BaseMap_ST;
  half4 _BaseColor;
  half _Cutoff, _Smoothness;
CBUFFER_END
TEXTURE2D(_BaseMap); SAMPLER(sampler_BaseMap);
TEXTURE2D(_BumpMap); SAMPLER(sampler_BumpMap);
struct Attributes { float4 positionOS : POSITION; float3 normalOS : NORMAL; float4 tangentOS : TANGENT; float2 uv : TEXCOORD0; };
struct Varyings {
  float2 uv : TEXCOORD0;
  float3 normalWS : TEXCOORD3;
#ifdef _NORMALMAP
  float4 tangentWS : TEXCOORD4;
#endif
  HARBOUR_FOG_COORDS(5)
  float4 positionCS : SV_POSITION;
};
real4 SampleAlbedo(float2 uv, TEXTURE2D_PARAM(map, sampler_map)) { return SAMPLE_TEXTURE2D(map, sampler_map, uv); }
real3 SampleSH(real3 n) { real4 v = real4(n, 1); return real3(dot(harbour_SHAr, v), dot(harbour_SHAg, v), dot(harbour_SHAb, v)); }
float3 ToWorld(float3 p) { return mul(UNITY_MATRIX_M, float4(p, 1.0)).xyz; }
Varyings vert(Attributes input) {
  Varyings output = (Varyings)0;
  float3 positionWS = ToWorld(input.positionOS.xyz);
#ifdef _VERTEX_SWAY
  positionWS.x += sin(_Time.y + positionWS.y) * SAMPLE_TEXTURE2D_LOD(_BumpMap, sampler_BumpMap, input.uv, 0).r;
#endif
  output.positionCS = mul(harbour_MatrixVP, float4(positionWS, 1.0));
  output.normalWS = normalize(mul(input.normalOS, (float3x3)harbour_WorldToObject));
#ifdef _NORMALMAP
  real sign = input.tangentOS.w * (harbour_LODFade.w < 0.0 ? -1.0 : 1.0);
  output.tangentWS = float4(mul((float3x3)UNITY_MATRIX_M, input.tangentOS.xyz), sign);
#endif
  output.uv = TRANSFORM_TEX(input.uv, _BaseMap);
  output.fogCoord = max(((1.0 - output.positionCS.z / _ProjectionParams.y) * _ProjectionParams.z), 0);
  return output;
}
half4 frag(Varyings input
#ifdef _DOUBLE_SIDED
  , bool face : SV_IsFrontFace
#endif
) : SV_Target {
  half4 albedo = SampleAlbedo(input.uv, TEXTURE2D_ARGS(_BaseMap, sampler_BaseMap)) * _BaseColor;
#if defined(_ALPHATEST_ON)
  clip(albedo.a - _Cutoff);
#endif
  float3 n = input.normalWS;
#ifdef _DOUBLE_SIDED
  n = face ? n : -n;
#endif
#ifdef _NORMALMAP
  half3 t = SAMPLE_TEXTURE2D(_BumpMap, sampler_BumpMap, input.uv).xyz * 2.0 - 1.0;
  float3 b = cross(n, input.tangentWS.xyz) * input.tangentWS.w;
  n = mul(t, float3x3(input.tangentWS.xyz, b, n));
#endif
  return half4(albedo.rgb * SampleSH(n) * _Smoothness + input.fogCoord * 0.01, albedo.a);
}
