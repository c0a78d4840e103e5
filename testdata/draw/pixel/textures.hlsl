// Textures with a level of detail from the neighbours: every method of Texture*, in structs and as parameters, in loops and branches.
// RUN: %draw compare %s -T ps_5_0 -E samples
// RUN: %draw compare %s -T ps_5_0 -E samples --target glsl450,vulkan --seed 2
// RUN: %draw compare %s -T ps_5_0 -E gradients --target glsl330,essl300,vulkan
// RUN: %draw compare %s -T ps_5_0 -E shapes --target glsl450,vulkan
// RUN: %draw compare %s -T ps_5_0 -E compares --target glsl450,glsl330,essl300,vulkan
// RUN: %draw compare %s -T ps_5_0 -E parameters
// RUN: %draw compare %s -T ps_5_0 -E flow --target glsl450,essl310,vulkan
// RUN: %draw compare %s -T ps_5_0 -E after_discard
Texture2D map;
Texture2DArray layers;
Texture3D volume;
TextureCube sky;
Texture1D ramp;
Texture2D shadow;
SamplerState linearly, sharp;
SamplerComparisonState nearer;
cbuffer C { int count; float4 scale; };

float4 samples(float4 v : V) : SV_Target {
  float4 c = map.Sample(linearly, v.xy);
  c += 2 * map.Sample(sharp, v.zw, int2(1, -2));
  c -= map.SampleBias(linearly, v.xy, 1);
  c += map.SampleLevel(linearly, v.zw, 2);
  return c + map.Load(int3(count & 1, 2, 0));
}
float4 gradients(float4 v : V) : SV_Target {
  return map.SampleGrad(sharp, v.xy, ddx(v.zw), ddy(v.zw)) - shadow.SampleGrad(linearly, v.zw, v.xy, 0, int2(1, 1));
}
float4 shapes(float4 v : V) : SV_Target {
  float4 c = layers.Sample(linearly, float3(v.xy, 1)) + volume.Sample(linearly, v.xyz);
  c += sky.Sample(linearly, v.xyz) + ramp.Sample(sharp, v.w);
  return c - layers.SampleBias(linearly, v.xyz, -0.5, int2(1, 1));
}
float4 compares(float4 v : V) : SV_Target {
  float lit = shadow.SampleCmp(nearer, v.xy, saturate(v.z));
  lit += 2 * shadow.SampleCmpLevelZero(nearer, v.zw, 0.5);
  return lit + 4 * shadow.SampleCmp(nearer, v.xy * 2, 0.25, int2(1, 0));
}

struct Material {
  Texture2D colors;
  SamplerState state;
  float4 tint;
};
float4 Read(Texture2D t, SamplerState s, float2 uv) { return t.Sample(s, uv); }
float4 Shade(Material m, float2 uv) { return m.tint * Read(m.colors, m.state, uv) + m.colors.SampleLevel(m.state, uv, 0); }
float4 parameters(float4 v : V) : SV_Target {
  Material m;
  m.colors = map;
  m.state = linearly;
  m.tint = scale;
  return Shade(m, v.xy) - Read(shadow, sharp, v.zw);
}

float4 flow(float4 v : V) : SV_Target {
  float4 sum = 0;
  for (int i = 0; i < (count & 3); ++i) sum += map.Sample(linearly, v.xy * (i + 1));
  if (scale.x > 0) sum += layers.Sample(sharp, v.xyz);
  return sum + (v.x > 0 ? map.Sample(linearly, v.zw) : shadow.Sample(linearly, v.wz));
}

float4 after_discard(float4 v : V) : SV_Target {
  clip(v.x * v.y);
  float4 c = map.Sample(linearly, v.zw);
  if (c.x > 1) discard;
  return c + map.Sample(sharp, v.xy);
}
