// Effects of Direct3D 11: an array texture, and structs in a buffer, which are set as bytes.
// SET Lights = 1 1 1 1  0.5 0.5 0.5 1
// DRAW Layered
// PIXEL 2 8 = 255 0 0 255
// PIXEL 13 8 = 128 128 128 255
struct Lamp { float3 color; float power; };
cbuffer Scene { Lamp Lights[2]; };
Texture2DArray Layers;
SamplerState Near { Filter = MIN_MAG_MIP_POINT; };
void VS(float4 p : POSITION, inout float2 uv : TEXCOORD0, out float4 position : SV_Position) { position = p; }
float4 PS(float2 uv : TEXCOORD0) : SV_Target {
  int layer = uv.x < 0.5 ? 0 : 1;
  float4 texel = Layers.Sample(Near, float3(layer == 0 ? 0.25 : 0.75, 0.5, layer));
  return float4(texel.rgb * Lights[layer].color * Lights[layer].power, 1);
}
technique11 Layered { pass P0 { SetVertexShader(CompileShader(vs_5_0, VS())); SetPixelShader(CompileShader(ps_5_0, PS())); } }
