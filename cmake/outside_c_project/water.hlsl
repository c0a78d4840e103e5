cbuffer Frame : register(b0) { float4x4 view_projection; };
cbuffer Clip : register(b1) { float3 light; float4 water; };
[clipplanes(water)]
float4 main(float3 position : POSITION) : SV_Position {
  return mul(float4(position + light, 1), view_projection);
}
