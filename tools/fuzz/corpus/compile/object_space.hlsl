//0002
float4 p; [clipplanes(p)] float4 main(float3 v : POSITION) : SV_Position { return float4(v, 1); }
