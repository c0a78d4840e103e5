// Textures in the pixel shader, and one that both sample.
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t --targets glsl450,glsl330,vulkan --forms glsl,spirv,hlsl
// Textures are fed by their names on OpenGL, and by their bindings on Vulkan.
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t --targets vulkan --forms pair
Texture2D heights : register(t0);
Texture2D colors : register(t1);
SamplerState point_sampler : register(s0);
struct Varyings { float4 position : SV_Position; float2 uv : TEXCOORD0; float height : HEIGHT; };
Varyings vs(float4 p : POSITION, float2 uv : TEXCOORD0) {
  Varyings v;
  v.position = p;
  v.uv = uv;
  v.height = uv.x;
  return v;
}
float4 ps(Varyings v) : SV_Target { return colors.Sample(point_sampler, v.uv) * v.height + heights.Sample(point_sampler, v.uv.yx); }
