// clipc water.hlsl --target=glsl330
StructuredBuffer<float4> offsets;
float4 main(float4 p : POSITION, uint id : SV_VertexID) : SV_Position { return p + offsets[id]; }
