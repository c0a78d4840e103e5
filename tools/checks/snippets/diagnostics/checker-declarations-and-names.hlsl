// clipc water.hlsl
cbuffer Frame { float4 offset; };
float4 main(float4 p : POSITION) : SV_Position { return p + ofset; }
