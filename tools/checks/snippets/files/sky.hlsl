float4x4 view_projection;
float4 main(float3 position : POSITION) : SV_Position { return mul(float4(position, 1), view_projection); }
