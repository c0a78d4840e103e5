// clipc water.hlsl
cbuffer Clip { float3 plane; };
[clipplanes(plane)]
float4 main(float4 p : POSITION) : SV_Position { return p; }
