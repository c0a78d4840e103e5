// clipc water.hlsl
cbuffer Clip : register(t0) { float4 plane; };
float4 main(float4 p : POSITION) : SV_Position { return p + plane; }
