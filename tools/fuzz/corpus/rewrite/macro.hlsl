#define PLANES [clipplanes(plane)]
#include "planes.hlsli"
cbuffer Clip { float4 plane; };
float4 main(float4 p : POSITION) : SV_Position;
PLANES float4 main(float4 p : POSITION) : SV_Position { return p; }
float4 Twice(float4 p) { return main(p) + main(p); }
technique T { pass P { VertexShader = compile vs_5_0 main(); } }
