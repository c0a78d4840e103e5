// MonoGame: fog by a vector, as its BasicEffect computes it, and lights in an array of structs.
// SET FogVector = 0.5 0 0 0.5
// DRAW Fogged
// PIXEL 0 8 = 8 0 247 255
// PIXEL 15 8 = 247 0 8 255
float4 FogVector;
float3 FogColor = {1, 0, 0};
float4 VS(float4 p : POSITION, out float fog : TEXCOORD0) : SV_Position { fog = saturate(dot(p, FogVector)); return p; }
float4 PS(float4 p : SV_Position, float fog : TEXCOORD0) : SV_Target { return float4(lerp(float3(0, 0, 1), FogColor, fog), 1); }
technique Fogged { pass P0 { VertexShader = compile vs_4_0_level_9_3 VS(); PixelShader = compile ps_4_0_level_9_3 PS(); } }
