#define OUTPOSITION SV_POSITION
#define OUTCOLOR0 SV_TARGET
#define Sample2D(tex, uv) t##tex.Sample(s##tex, uv)
#define Sample2DLod0(tex, uv) t##tex.SampleLevel(s##tex, uv, 0.0)
#define NETTLE_TEXTURE(kind, name, n) kind t##name : register(t##n); SamplerState s##name : register(s##n)
NETTLE_TEXTURE(Texture2D, DiffMap, 0);
NETTLE_TEXTURE(TextureCube, EnvMap, 4);
#ifdef COMPILEVS
cbuffer FrameVS : register(b0) { float cDeltaTime; float cElapsedTime; }
cbuffer CameraVS : register(b1) { float3 cCameraPos; float cNearClip; float cFarClip; float4 cDepthMode; float4x4 cViewProj; float4 cClipPlane; }
cbuffer ObjectVS : register(b5) {
  float4x3 cModel;
#ifdef BILLBOARD
  float3x3 cBillboardRot;
#endif
#ifdef SKINNED
  uniform float4x3 cSkinMatrices[16];
#endif
}
#define iModelMatrix modelMatrix
float GetDepth(float4 clipPos) { return dot(clipPos.zw, cDepthMode.zw); }
#endif
void VS(float4 iPos : POSITION, float3 iNormal : NORMAL, float2 iTexCoord : TEXCOORD0,
#ifdef SKINNED
  float4 iBlendWeights : BLENDWEIGHT, int4 iBlendIndices : BLENDINDICES,
#endif
#ifdef BILLBOARD
  float2 iSize : TEXCOORD1,
#endif
  out float2 oTexCoord : TEXCOORD0, out float4 oWorldPos : TEXCOORD3,
#if defined(CLIPPED)
  out float oClip : SV_CLIPDISTANCE0,
#endif
  out float3 oNormal : TEXCOORD1, out float4 oPos : OUTPOSITION)
{
#ifdef COMPILEVS
#ifdef SKINNED
  float4x3 modelMatrix = cSkinMatrices[iBlendIndices.x] * iBlendWeights.x + cSkinMatrices[iBlendIndices.y] * iBlendWeights.y;
#else
  float4x3 modelMatrix = cModel;
#endif
  float3 worldPos = mul(iPos, iModelMatrix);
#ifdef BILLBOARD
  worldPos += mul(float3(iSize.x, iSize.y, 0.0), cBillboardRot);
#endif
  oPos = mul(float4(worldPos, 1.0), cViewProj);
  oNormal = normalize(mul(iNormal, (float3x3)iModelMatrix));
  oWorldPos = float4(worldPos, GetDepth(oPos));
  oTexCoord = iTexCoord;
#if defined(CLIPPED)
  oClip = dot(oPos, cClipPlane);
#endif
#endif
}
#ifdef COMPILEPS
cbuffer MaterialPS : register(b4) { float4 cMatDiffColor; float3 cMatEmissiveColor; float cRoughness; }
void PS(float2 iTexCoord : TEXCOORD0, float4 iWorldPos : TEXCOORD3,
#if defined(CLIPPED)
  float iClip : SV_CLIPDISTANCE0,
#endif
  float3 iNormal : TEXCOORD1,
#ifdef DEFERRED
  out float4 oAlbedo : SV_TARGET1, out float4 oNormal : SV_TARGET2, out float4 oDepth : SV_TARGET3,
#endif
  out float4 oColor : OUTCOLOR0)
{
  float4 diffInput = Sample2D(DiffMap, iTexCoord);
#ifdef ALPHAMASK
  if (diffInput.a < 0.5) discard;
#endif
  float4 diffColor = cMatDiffColor * diffInput;
#ifdef ENVCUBEMAP
  diffColor.rgb += Sample2D(EnvMap, reflect(iWorldPos.xyz, iNormal)).rgb * cRoughness;
#endif
#ifdef DEFERRED
  oAlbedo = float4(diffColor.rgb, 0.5);
  oNormal = float4(iNormal * 0.5 + 0.5, 1.0);
  oDepth = iWorldPos.w;
#endif
  oColor = float4(cMatEmissiveColor + diffColor.rgb, diffColor.a);
}
#endif
