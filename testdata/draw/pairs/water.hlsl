// The two shaders of the lake of examples/water, in HLSL: the ground, lit, and the water over it, which reflects more the flatter the eye looks.
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t --targets glsl450,glsl330,essl310,vulkan --forms pair
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t --targets glsl450,vulkan --forms hlsl,spirv
cbuffer Object : register(b0) {
  float4x4 world_view_projection;
  float4x4 world;
};
cbuffer Surface : register(b1) {
  float4 color;
  float4 eye;  // in world space; of a reflection, mirrored
};
struct Varyings {
  float4 position : SV_Position;
  float3 normal : NORMAL;
  float3 place : TEXCOORD0;
  nointerpolation float water : WATER;
};
Varyings vs(float4 position : POSITION, float3 normal : NORMAL) {
  Varyings v;
  v.position = position;
  v.normal = mul(normal, (float3x3)world);
  v.place = mul(float4(position.xyz, 1), world).xyz;
  v.water = frac(world[3].x);
  return v;
}
float4 ps(Varyings v) : SV_Target {
  const float3 to_eye = normalize(eye.xyz - v.place);
  if (v.water > 0.5) {
    const float reflected = 0.35 + 0.65 * pow(saturate(1 - to_eye.y), 5);
    return float4(color.rgb, 1 - reflected);
  }
  float3 normal = normalize(v.normal);
  const float3 to_sun = float3(-0.48, 0.64, -0.6);
  if (dot(normal, to_eye) < 0) normal = -normal;
  const float light = 0.45 + 0.15 * normal.y + 0.5 * max(0, dot(normal, to_sun));
  const float shine = 0.35 * pow(max(0, dot(normal, normalize(to_sun + to_eye))), 40);
  return float4(color.rgb * light + shine, 1);
}
