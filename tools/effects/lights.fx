// Direct3D 9: a loop over lights that the technique counts.
// DRAW TwoLights
// PIXEL 8 8 = 128 128 0 255
// DRAW OneLight
// PIXEL 8 8 = 128 0 0 255
float3 LightDir[3] = {float3(0, 0, -1), float3(0, 0, -1), float3(0, 0, 1)};
float4 LightDiffuse[3] = {float4(0.5, 0, 0, 1), float4(0, 0.5, 0, 1), float4(0, 0, 0.5, 1)};
void VS(inout float4 p : POSITION, float3 n : NORMAL, out float4 c : COLOR0, uniform int count) {
  c = float4(0, 0, 0, 1);
  for (int i = 0; i < count; i++) c.rgb += LightDiffuse[i].rgb * max(0, dot(n, LightDir[i]));
}
float4 PS(float4 c : COLOR0) : COLOR { return c; }
technique OneLight { pass P0 { VertexShader = compile vs_2_0 VS(1); PixelShader = compile ps_2_0 PS(); } }
technique TwoLights { pass P0 { VertexShader = compile vs_2_0 VS(2); PixelShader = compile ps_2_0 PS(); } }
