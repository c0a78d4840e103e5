// The structure of a toolkit's BasicEffect: one set of constants, many entries that share functions.
Texture2D<float4> Texture : register(t0);
sampler Sampler : register(s0);
cbuffer Parameters : register(b0) {
  float4 DiffuseColor : packoffset(c0);
  float3 EmissiveColor : packoffset(c1);
  float3 SpecularColor : packoffset(c2);
  float SpecularPower : packoffset(c2.w);
  float3 LightDirection[3] : packoffset(c3);
  float3 LightDiffuseColor[3] : packoffset(c6);
  float3 LightSpecularColor[3] : packoffset(c9);
  float3 EyePosition : packoffset(c12);
  float3 FogColor : packoffset(c13);
  float4 FogVector : packoffset(c14);
  float4x4 World : packoffset(c15);
  float3x3 WorldInverseTranspose : packoffset(c19);
  float4x4 WorldViewProj : packoffset(c22);
};
struct ColorPair { float3 Diffuse; float3 Specular; };
struct CommonVSOutput { float4 Pos_ps; float4 Diffuse; float3 Specular; float FogFactor; };
struct VSInput { float4 Position : SV_Position; };
struct VSInputNmTxVc { float4 Position : SV_Position; float3 Normal : NORMAL; float2 TexCoord : TEXCOORD0; float4 Color : COLOR; };
struct VSOutputTx { float4 Diffuse : COLOR0; float4 Specular : COLOR1; float2 TexCoord : TEXCOORD0; float4 PositionPS : SV_Position; };
struct VSOutputPixelLighting { float4 PositionWS : TEXCOORD0; float3 NormalWS : TEXCOORD1; float4 Diffuse : COLOR0; float4 PositionPS : SV_Position; };
ColorPair ComputeLights(float3 eye, float3 n, uniform int numLights) {
  float3x3 lightDirections = 0, lightDiffuse = 0, lightSpecular = 0, halfVectors = 0;
  [unroll] for (int i = 0; i < numLights; i++) {
    lightDirections[i] = LightDirection[i];
    lightDiffuse[i] = LightDiffuseColor[i];
    lightSpecular[i] = LightSpecularColor[i];
    halfVectors[i] = normalize(eye - lightDirections[i]);
  }
  float3 dotL = mul(-lightDirections, n);
  float3 dotH = mul(halfVectors, n);
  float3 zeroL = step(0, dotL);
  ColorPair r;
  r.Diffuse = mul(zeroL * dotL, lightDiffuse) * DiffuseColor.rgb + EmissiveColor;
  r.Specular = mul(pow(max(dotH, 0) * zeroL, SpecularPower) * dotL, lightSpecular) * SpecularColor;
  return r;
}
CommonVSOutput ComputeCommonVSOutput(float4 position) {
  CommonVSOutput vout;
  vout.Pos_ps = mul(position, WorldViewProj);
  vout.Diffuse = DiffuseColor;
  vout.Specular = 0;
  vout.FogFactor = saturate(dot(position, FogVector));
  return vout;
}
#define SetCommon vout.PositionPS = cout.Pos_ps; vout.Diffuse = cout.Diffuse; vout.Specular = float4(cout.Specular, cout.FogFactor);
VSOutputTx VSBasicTx(VSInputNmTxVc vin) { VSOutputTx vout; CommonVSOutput cout = ComputeCommonVSOutput(vin.Position); SetCommon; vout.TexCoord = vin.TexCoord; return vout; }
VSOutputTx VSVertexLighting(VSInputNmTxVc vin) {
  VSOutputTx vout;
  CommonVSOutput cout = ComputeCommonVSOutput(vin.Position);
  float3 eye = normalize(EyePosition - mul(vin.Position, World).xyz);
  ColorPair light = ComputeLights(eye, normalize(mul(vin.Normal, WorldInverseTranspose)), 3);
  cout.Diffuse = float4(light.Diffuse, DiffuseColor.a) * vin.Color;
  cout.Specular = light.Specular;
  SetCommon;
  vout.TexCoord = vin.TexCoord;
  return vout;
}
VSOutputPixelLighting VSPixelLighting(VSInputNmTxVc vin) {
  VSOutputPixelLighting vout;
  vout.PositionPS = mul(vin.Position, WorldViewProj);
  vout.PositionWS = float4(mul(vin.Position, World).xyz, saturate(dot(vin.Position, FogVector)));
  vout.NormalWS = normalize(mul(vin.Normal, WorldInverseTranspose));
  vout.Diffuse = float4(1, 1, 1, DiffuseColor.a);
  return vout;
}
float4 VSDepthOnly(VSInput vin) : SV_Position { return mul(vin.Position, WorldViewProj); }
void ApplyFog(inout float4 color, float fogFactor) { color.rgb = lerp(color.rgb, FogColor * color.a, fogFactor); }
float4 PSBasicTx(VSOutputTx pin) : SV_Target0 { float4 color = Texture.Sample(Sampler, pin.TexCoord) * pin.Diffuse; ApplyFog(color, pin.Specular.w); return color; }
float4 PSVertexLighting(VSOutputTx pin) : SV_Target0 { float4 color = pin.Diffuse; color.rgb += pin.Specular.rgb * color.a; ApplyFog(color, pin.Specular.w); return color; }
float4 PSPixelLighting(VSOutputPixelLighting pin) : SV_Target0 {
  ColorPair light = ComputeLights(normalize(EyePosition - pin.PositionWS.xyz), normalize(pin.NormalWS), 1);
  float4 color = pin.Diffuse * float4(light.Diffuse, 1);
  color.rgb += light.Specular * color.a;
  ApplyFog(color, pin.PositionWS.w);
  return color;
}
