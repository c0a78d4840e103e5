// Direct3D 9's samplers that compare, and one beside them that does not.
// RUN: %draw compare %s -T ps_3_0 --shadow-samplers map --target glsl450,glsl330,glsl120,essl310,vulkan
// RUN: %draw compare %s -T ps_3_0 -E levels --shadow-samplers map --target glsl450,glsl330,essl310,vulkan
sampler2D map;
sampler2D colors;
float Shadow(sampler2D s, float4 p) { return tex2Dproj(s, p).w; }
float4 main(float4 p : TEXCOORD0, float4 q : TEXCOORD1) : COLOR0 {
  float4 lit = tex2Dproj(map, float4(p.xy, abs(q.x), 1 + abs(q.y)));
  return lit * tex2D(colors, q.xy) + Shadow(map, float4(q.zw, frac(p.x), 1)) * tex2Dproj(colors, float4(p.xyz, 2));
}
float4 levels(float4 p : TEXCOORD0, float4 q : TEXCOORD1) : COLOR0 {
  float4 lit = tex2Dlod(map, float4(p.xy, frac(q.z), 1)) + tex2Dbias(map, float4(q.xy, frac(p.z), 0.25)) * 2;
  return lit + tex2Dlod(colors, float4(p.zw, q.x, 1)) * tex2Dbias(colors, float4(q.zw, p.x, 0.25));
}
