// A walk over an effect, with annotations of all that has them.
// WALK = Draw<string Script="x"> First<int Order=1><bool Clear=true> Second Tint<float UIMin=0.0> Map<string ResourceName="a.dds">
// DRAW Draw Second
// PIXEL 2 2 = 255 0 0 255
float4 Tint <float UIMin = 0.0;> = {1, 1, 1, 1};
texture Map <string ResourceName = "a.dds";>;
sampler Maps = sampler_state { Texture = <Map>; };
void VS(float4 p : POSITION, inout float2 uv : TEXCOORD0, out float4 position : POSITION) { position = p; }
float4 PS(float2 uv : TEXCOORD0) : COLOR { return tex2D(Maps, uv) * Tint; }
technique Draw <string Script = "x";> {
  pass First <int Order = 1; bool Clear = true;> { VertexShader = compile vs_3_0 VS(); PixelShader = compile ps_3_0 PS(); }
  pass Second { VertexShader = compile vs_3_0 VS(); PixelShader = compile ps_3_0 PS(); ZEnable = false; CullMode = None; }
}
