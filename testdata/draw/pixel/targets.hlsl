// Render targets: several, with numbers left out, of integers and of few components; the depth; and pixels that are not drawn.
// RUN: %draw compare %s -T ps_5_0 -E several
// RUN: %draw compare %s -T ps_3_0 -E several9 --target glsl450,glsl120,essl100,essl300,vulkan
// RUN: %draw compare %s -T ps_5_0 -E parts --target glsl450,glsl130,essl310,vulkan
// RUN: %draw compare %s -T ps_5_0 -E depth
// RUN: %draw compare %s -T ps_5_0 -E depth_greater --target glsl450,vulkan
// RUN: %draw compare %s -T ps_5_0 -E discards
// RUN: %draw compare %s -T ps_3_0 -E clips --target glsl450,glsl120,essl100,vulkan
struct Several {
  float4 a : SV_Target;
  float2 b : SV_Target3;
  float3 c : SV_Target1;
};
Several several(float4 v : V) {
  Several s;
  s.c = v.zyx;
  s.a = v * 2;
  s.b = s.a.xy - s.c.yz;
  return s;
}
void several9(float4 v : TEXCOORD0, out float4 second : COLOR1, out float4 first : COLOR0) {
  first = v;
  second = first.wzyx * v.x;
}
void parts(float4 v : V, int n : N, out float a : SV_Target0, out int2 b : SV_Target1, out uint c : SV_Target2) {
  a = v.x > 0 ? v.y : v.z;
  b = int2(n, n * n);
  c = (uint)(v.w * 4 + 8);
}
float4 depth(float4 p : SV_Position, float4 v : V, out float d : SV_Depth) : SV_Target {
  d = v.x > 0 ? saturate(v.y * 0.25 + 0.5) : p.z;
  return v;
}
float depth_greater(float4 p : SV_Position, float4 v : V, out float d : SV_DepthGreaterEqual) : SV_Target {
  d = p.z + saturate(v.y) * 0.125;
  return d;
}
float4 discards(float4 v : V, out float d : SV_Depth) : SV_Target0 {
  d = 0.25;
  if (v.x > v.y) {
    if (v.z > 0) discard;
    d = 0.75;
  }
  for (int i = 0; i < 3; ++i) {
    if (v.w > 1.5 - i * 0.25) discard;
  }
  return v;
}
float4 clips(float4 v : TEXCOORD0) : COLOR {
  clip(v - float4(-1, -1.5, -1.25, -1.75));
  clip(v.x + v.y);
  return v.wzyx;
}
