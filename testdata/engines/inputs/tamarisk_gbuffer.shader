#define META_VS(isVisible, level)
#define META_PS(isVisible, level)
#define META_VS_IN_ELEMENT(type, index, format, slot, offset, rate, data, on)
#define META_PERMUTATION_1(a)
#define META_FLAG(f)
#define META_CB_BEGIN(index, name) cbuffer name : register(b##index) {
#define META_CB_END };
#define GATHER4(n) n.Gather(SamplerPointClamp, uv)
struct GBufferSample { float3 Normal; float Roughness; float3 WorldPos; float Metalness; };
struct GBufferData { float4 ViewInfo; float4 ScreenSize; float3 ViewPos; float Pad0; float4x4 InvViewMatrix; };
#define DECLARE_GBUFFERDATA_ACCESS(uniformName) GBufferData Get##uniformName##Data() { return uniformName; }
META_CB_BEGIN(0, Data)
GBufferData GBuffer;
float4x4 WVP;
float2 Dummy0; float Alpha; uint Mode;
META_CB_END
DECLARE_GBUFFERDATA_ACCESS(GBuffer)
Texture2D Input0 : register(t0); Texture2D<float> Input1 : register(t1); Texture2D<uint2> Input2 : register(t2);
SamplerState SamplerLinearClamp : register(s0); SamplerState SamplerPointClamp : register(s1);
struct Quad_VS2PS { float4 Position : SV_Position; float2 TexCoord : TEXCOORD0; };
float LinearizeZ(GBufferData g, float depth) { return g.ViewInfo.w / (depth - g.ViewInfo.z); }
float3 GetWorldPos(GBufferData g, float2 uv, float d) { float3 v = float3(uv * 2 - 1, d); return mul(float4(v * LinearizeZ(g, d), 1), g.InvViewMatrix).xyz; }
META_VS(true, FEATURE_LEVEL_ES2)
META_VS_IN_ELEMENT(POSITION, 0, R32G32_FLOAT, 0, ALIGN, PER_VERTEX, 0, true)
Quad_VS2PS VS_Quad(float2 Position : POSITION, float2 TexCoord : TEXCOORD0) {
  Quad_VS2PS output;
  output.Position = float4(Position, 0, 1);
  output.TexCoord = TexCoord;
  return output;
}
META_VS(true, FEATURE_LEVEL_ES2)
Quad_VS2PS VS_FullScreen(uint id : SV_VertexID) {
  Quad_VS2PS output;
  output.TexCoord = float2((id << 1) & 2, id & 2);
  output.Position = float4(output.TexCoord * float2(2, -2) + float2(-1, 1), 0, 1);
  return output;
}
META_PS(true, FEATURE_LEVEL_SM5)
META_PERMUTATION_1(USE_X=1)
float4 PS_Main(Quad_VS2PS input) : SV_Target0 {
  GBufferData g = GetGBufferData();
  GBufferSample s;
  float d = Input1.SampleLevel(SamplerPointClamp, input.TexCoord, 0);
  s.Normal = Input0.Sample(SamplerLinearClamp, input.TexCoord).xyz * 2 - 1;
  s.WorldPos = GetWorldPos(g, input.TexCoord, d);
  s.Metalness = s.Roughness = Alpha;
#if USE_MASK
  uint w, h; Input2.GetDimensions(w, h);
  uint2 mask = Input2.Load(int3(input.TexCoord * float2(w, h), 0));
  if ((mask.x & Mode) != 0 || mask.y == 0xff) discard;
#endif
  switch (Mode) {
    case 0: return float4(s.Normal, 1);
    case 1: case 2: return float4(s.WorldPos, s.Roughness);
    default: break;
  }
  return Alpha.xxxx * length(ddx(s.WorldPos)) + fwidth(d);
}
