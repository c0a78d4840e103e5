cbuffer Frame : register(b0) { float4x4 view; float4 tint; };
Texture2D albedo;
SamplerState linear_sampler;
float4 main(float2 uv : TEXCOORD0, float3x3 tangents : TANGENT, float4 p : SV_Position) : SV_Target {
  clip(uv.x - 0.5);
  if (ddx(uv.y) > 1) discard;
  return albedo.Sample(linear_sampler, uv) * tint + tangents[1].xyzz;
}
