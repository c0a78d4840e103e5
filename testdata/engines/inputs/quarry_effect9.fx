// Effects framework of Direct3D 9, with annotations, states and uniform arguments of entry points.
string XFile <string Use = "preview";> = "tiny.x";
int BCLR = 0xff202080;
float4 lhtDir <string Object = "DirectionalLight"; string Space = "World";> = {0.0f, 0.0f, -1.0f, 1.0f};
float4 lightDiffuse = {0.6f, 0.6f, 0.6f, 1.0f};
float4 MaterialAmbient : MATERIALAMBIENT = {0.1f, 0.1f, 0.1f, 1.0f};
float4 MaterialDiffuse : MATERIALDIFFUSE = {0.8f, 0.8f, 0.8f, 1.0f};
static const int MAX_MATRICES = 26;
float4x3 mWorldMatrixArray[MAX_MATRICES] : WORLDMATRIXARRAY;
float4x4 mViewProj : VIEWPROJECTION;
int CurNumBones = 2;
texture g_MeshTexture;
texture g_LightMap <string name = "lights.dds";>;
sampler MeshTextureSampler = sampler_state { Texture = <g_MeshTexture>; MipFilter = LINEAR; MinFilter = LINEAR; MagFilter = LINEAR; };
sampler2D LightSampler = sampler_state { texture = (g_LightMap); AddressU = CLAMP; AddressV = CLAMP; };
struct VS_INPUT { float4 Pos : POSITION; float4 BlendWeights : BLENDWEIGHT; float4 BlendIndices : BLENDINDICES; float3 Normal : NORMAL; float3 Tex0 : TEXCOORD0; };
struct VS_OUTPUT { float4 Pos : POSITION; float4 Diffuse : COLOR; float2 Tex0 : TEXCOORD0; };
float3 Diffuse(float3 Normal) { float CosTheta = max(0.0f, dot(Normal, lhtDir.xyz)); return (CosTheta); }
VS_OUTPUT VShade(VS_INPUT i, uniform int NumBones) {
  VS_OUTPUT o;
  float3 Pos = 0.0f, Normal = 0.0f;
  float LastWeight = 0.0f;
  int4 IndexVector = D3DCOLORtoUBYTE4(i.BlendIndices);
  float BlendWeightsArray[4] = (float[4])i.BlendWeights;
  int IndexArray[4] = (int[4])IndexVector;
  for (int iBone = 0; iBone < NumBones - 1; iBone++) {
    LastWeight = LastWeight + BlendWeightsArray[iBone];
    Pos += mul(i.Pos, mWorldMatrixArray[IndexArray[iBone]]) * BlendWeightsArray[iBone];
    Normal += mul(i.Normal, mWorldMatrixArray[IndexArray[iBone]]) * BlendWeightsArray[iBone];
  }
  LastWeight = 1.0f - LastWeight;
  Pos += (mul(i.Pos, mWorldMatrixArray[IndexArray[NumBones - 1]]) * LastWeight);
  Normal += (mul(i.Normal, mWorldMatrixArray[IndexArray[NumBones - 1]]) * LastWeight);
  o.Pos = mul(float4(Pos.xyz, 1.0f), mViewProj);
  Normal = normalize(Normal);
  o.Diffuse.xyz = MaterialAmbient.xyz + Diffuse(Normal) * MaterialDiffuse.xyz;
  o.Diffuse.w = 1.0f;
  o.Tex0 = i.Tex0.xy;
  return o;
}
VS_OUTPUT VSkin1(VS_INPUT i) { return VShade(i, 1); }
VS_OUTPUT VSkin2(VS_INPUT i) { return VShade(i, 2); }
VS_OUTPUT VSkin4(VS_INPUT i) { return VShade(i, 4); }
float4 PShade(VS_OUTPUT In, uniform bool bLit) : COLOR0 {
  if (bLit) return tex2D(MeshTextureSampler, In.Tex0) * In.Diffuse;
  else return tex2D(MeshTextureSampler, In.Tex0);
}
float4 PLit(VS_OUTPUT In) : COLOR0 { return PShade(In, true) + tex2D(LightSampler, In.Tex0); }
float4 PFlat(VS_OUTPUT In) : COLOR0 { return PShade(In, false); }
VertexShader vsArray20[2] = { compile vs_2_0 VShade(1), compile vs_2_0 VShade(2) };
technique t0 {
  pass p0 { VertexShader = (vsArray20[CurNumBones]); PixelShader = compile ps_2_0 PShade(true); CullMode = NONE; ZEnable = TRUE; AlphaBlendEnable = FALSE; }
}
technique t1 <string Script = "Pass=p0;";> { pass p0 <string Script = "Draw=geometry;";> { VertexShader = compile vs_2_0 VShade(4); PixelShader = NULL; SrcBlend = SRCALPHA; } }
