cbuffer Frame : register(b0) { float4x4 view_projection; };
cbuffer Clip : register(b1) { float4 water_plane; };

[clipplanes(water_plane)]
float4 main(float3 position : POSITION) : SV_Position {
  return mul(float4(position, 1), view_projection);
}
