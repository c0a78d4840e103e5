cbuffer Frame : register(b0) { float4x4 view_projection; };
cbuffer Clip : register(b1) { float4 water_plane; };
Texture2D colours : register(t1);
SamplerState smooth : register(s1);

struct Varyings {
  float4 position : SV_Position;
  float2 uv : TEXCOORD0;
};

[clipplanes(water_plane)]
Varyings vs(float3 position : POSITION, float2 uv : TEXCOORD0) {
  Varyings output;
  output.position = mul(float4(position, 1), view_projection);
  output.uv = uv;
  return output;
}

float4 ps(Varyings input) : SV_Target { return colours.Sample(smooth, input.uv); }

[clipplanes(water_plane)]
float4 main(float3 position : POSITION) : SV_Position { return mul(float4(position, 1), view_projection); }

[clipplanes(water_plane)]
float4 depth(float3 position : POSITION) : SV_Position { return mul(float4(position, 1), view_projection); }

float4 vert(float3 position : POSITION) : SV_Position { return mul(float4(position, 1), view_projection); }
