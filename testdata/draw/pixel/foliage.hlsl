// Alpha-tested leaves with mip levels: the level of detail of a pixel comes from all four of its quad, also of those that the test has
// discarded, whose alpha decides before the colours are read.
// RUN: %draw compare %s -T ps_5_0
// RUN: %draw compare %s -T ps_5_0 --target glsl450,glsl330,essl300,vulkan --seed 5
// RUN: %draw compare %s -T ps_5_0 -E depth --target glsl450,glsl130,essl300,vulkan
// RUN: %draw compare %s -T ps_2_0 -E old --target glsl120,essl100
Texture2D leaves, veins;
SamplerState smoothly;
float4 main(float2 uv : UV, float4 light : LIGHT) : SV_Target {
  const float alpha = leaves.Sample(smoothly, uv).a + light.w;
  clip(alpha - 0.5);
  return veins.Sample(smoothly, uv * 3) * light;
}
// The test, and a depth of the leaf's own.
struct Leaf {
  float4 color : SV_Target;
  float depth : SV_Depth;
};
Leaf depth(float2 uv : UV, float4 light : LIGHT) {
  Leaf leaf;
  leaf.color = leaves.Sample(smoothly, uv);
  clip(leaf.color.a + light.w - 0.5);
  leaf.depth = saturate(light.x);
  leaf.color.rgb *= veins.Sample(smoothly, uv).rgb;
  return leaf;
}
sampler2D old_leaves;
float4 old(float2 uv : TEXCOORD0, float4 light : COLOR0) : COLOR {
  const float4 color = tex2D(old_leaves, uv);
  clip(color.a - light.w);
  return color * light;
}
// The same on an image of four samples a pixel: a pixel on the edge of two triangles runs once for each.
// RUN: %draw compare %s -T ps_5_0 --target glsl450,glsl330,essl300,essl310,vulkan --samples 4
// RUN: %draw compare %s -T ps_5_0 -E depth --target glsl450,essl300,vulkan --samples 4
// RUN: %draw compare %s -T ps_6_0 -E count --target glsl450 --samples 4
float4 count(float2 uv : UV) : SV_Target {
  clip(leaves.Sample(smoothly, uv).a - 0.25);
  return float4(GetRenderTargetSampleCount(), uv, 0);
}
