// clipc water.hlsl --lower=near-plane
cbuffer Clip { float4 a, b; };
[clipplanes(a, b)]
float4 main(float4 p : POSITION) : SV_Position { return p; }
