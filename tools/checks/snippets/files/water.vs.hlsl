cbuffer Frame : register(b0) { float4x4 view_projection; };
cbuffer Clip : register(b1) { float4 water_plane; };

[clipplanes(water_plane)]
void main(float3 p : POSITION, float2 uv : TEXCOORD0, out float4 position : SV_Position, out float2 coordinates : TEXCOORD0) {
  position = mul(float4(p, 1), view_projection);
  coordinates = uv;
}
