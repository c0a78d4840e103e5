cbuffer Frame { float4x4 view_projection; float3 water_plane; };

[clipplanes(water_plane)]
float4 main(float4 position : POSITION) : SV_Position { return mul(position, view_projection); }
