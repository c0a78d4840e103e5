// FNA and XNA: a blur whose offsets and weights are arrays that the application sets.
// SET SampleOffsets = -0.25 0  0.25 0  0 -0.25  0 0.25
// SET SampleWeights = 0.25 0.25 0.25 0.25
// DRAW GaussianBlur
// PIXEL 1 1 = 255 0 0 255
// PIXEL 8 8 = 128 191 191 255
#define SAMPLE_COUNT 4
sampler TextureSampler : register(s0);
float2 SampleOffsets[SAMPLE_COUNT];
float SampleWeights[SAMPLE_COUNT];
void VS(inout float4 p : POSITION0, inout float2 uv : TEXCOORD0) {}
float4 PixelShaderFunction(float2 texCoord : TEXCOORD0) : COLOR0 {
  float4 c = 0;
  for (int i = 0; i < SAMPLE_COUNT; i++) {
    float2 at = saturate(texCoord + SampleOffsets[i]);
    c += tex2D(TextureSampler, 0.25 + 0.5 * step(0.5, at)) * SampleWeights[i];
  }
  return c;
}
technique GaussianBlur { pass Pass1 { VertexShader = compile vs_2_0 VS(); PixelShader = compile ps_2_0 PixelShaderFunction(); } }
