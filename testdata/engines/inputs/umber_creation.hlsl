#if defined(VSHADER) || defined(PSHADER)
struct VS_INPUT {
  float4 Position : POSITION0;
#if defined(TEXTURE)
  float2 TexCoord0 : TEXCOORD0;
#endif
#if defined(NORMALS)
  float4 Normal : NORMAL0;
#endif
#if defined(VC)
  float4 Color : COLOR0;
#endif
};
struct VS_OUTPUT {
  float4 Position : SV_POSITION0;
#if defined(TEXTURE)
  float2 TexCoord0 : TEXCOORD0;
#endif
#if defined(VC)
  float4 Color : COLOR0;
#endif
  float4 WorldPosition : POSITION1;
#if defined(EFFECT) && !defined(VC)
  row_major float3x4 World : POSITION2;
#endif
};
typedef VS_OUTPUT PS_INPUT;
#endif
#ifdef VSHADER
cbuffer PerTechnique : register(b0) { float4 HighDetailRange : packoffset(c0); float2 ParabolaParam : packoffset(c1.z); };
cbuffer PerGeometry : register(b2) {
#if !defined(VR)
  row_major float4x4 ViewProj[1] : packoffset(c0);
  row_major float3x4 World[1] : packoffset(c8);
#else
  row_major float4x4 ViewProj[2] : packoffset(c0);
  row_major float3x4 World[2] : packoffset(c8);
#endif
  float3 EyePosition : packoffset(c16);
};
VS_OUTPUT main(VS_INPUT input) {
  VS_OUTPUT vsout;
  precise float4 worldPosition = float4(mul(World[0], input.Position), 1);
  vsout.Position = mul(ViewProj[0], worldPosition);
  vsout.WorldPosition = worldPosition - float4(EyePosition, 0);
#if defined(TEXTURE)
  vsout.TexCoord0 = input.TexCoord0 * HighDetailRange.xy + ParabolaParam;
#endif
#if defined(VC)
  vsout.Color = input.Color;
#elif defined(EFFECT)
  vsout.World = World[0];
#endif
#if defined(NORMALS)
  vsout.WorldPosition.w = dot(input.Normal.xyz, worldPosition.xyz);
#endif
  return vsout;
}
#endif
#ifdef PSHADER
struct PS_OUTPUT { float4 Albedo : SV_Target0; float4 MotionVectors : SV_Target1; };
SamplerState SampDiffuse : register(s0); Texture2D<float4> TexDiffuse : register(t0);
cbuffer PerMaterial : register(b1) { float4 BaseColor; float4 LightingInfluence; };
PS_OUTPUT main(PS_INPUT input) {
  PS_OUTPUT psout;
  float4 baseColor = BaseColor;
#if defined(TEXTURE)
  baseColor *= TexDiffuse.Sample(SampDiffuse, input.TexCoord0);
#endif
#if defined(VC)
  baseColor *= input.Color;
#elif defined(EFFECT)
  baseColor.xyz += mul(input.World, input.WorldPosition);
#endif
  psout.Albedo = baseColor;
  psout.MotionVectors = float4(input.WorldPosition.xyz, LightingInfluence.w > 0 ? 1.0 : 0.0);
  return psout;
}
#endif
