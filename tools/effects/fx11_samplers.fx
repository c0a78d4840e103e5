// Effects of Direct3D 11: textures and samplers apart, filters in one word, and a sampler that compares.
// DRAW Samplers Point
// PIXEL 2 2 = 255 0 0 255
// PIXEL 13 13 = 255 255 255 255
// DRAW Samplers Linear
// PIXEL 2 2 = 255 0 0 255
// DRAW Samplers Compare
// PIXEL 2 8 = 255 255 255 255
// PIXEL 13 8 = 0 0 0 255
Texture2D Map;
Texture2D ShadowMap;
SamplerState PointClamp { Filter = MIN_MAG_MIP_POINT; AddressU = Clamp; AddressV = Clamp; };
SamplerState LinearClamp { Filter = MIN_MAG_LINEAR_MIP_POINT; AddressU = CLAMP; AddressV = CLAMP; MaxLOD = 0; };
SamplerComparisonState Compare { Filter = COMPARISON_MIN_MAG_MIP_POINT; ComparisonFunc = LESS_EQUAL; };
void VS(inout float4 p : POSITION, inout float2 uv : TEXCOORD0, out float4 position : SV_Position) { position = p; }
float4 Plain(float4 p : POSITION, float2 uv : TEXCOORD0) : SV_Target { return Map.Sample(PointClamp, uv); }
float4 Smooth(float4 p : POSITION, float2 uv : TEXCOORD0) : SV_Target { return Map.Sample(LinearClamp, uv); }
float4 Shadow(float4 p : POSITION, float2 uv : TEXCOORD0) : SV_Target { return float4(ShadowMap.SampleCmpLevelZero(Compare, uv, uv.x).xxx, 1); }
technique11 Samplers {
  pass Point { SetVertexShader(CompileShader(vs_5_0, VS())); SetPixelShader(CompileShader(ps_5_0, Plain())); }
  pass Linear { SetVertexShader(CompileShader(vs_5_0, VS())); SetPixelShader(CompileShader(ps_5_0, Smooth())); }
  pass Compare { SetVertexShader(CompileShader(vs_5_0, VS())); SetPixelShader(CompileShader(ps_5_0, Shadow())); }
}
