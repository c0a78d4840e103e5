// Direct3D 9's functions that read textures, and its samplers.
// RUN: %draw compare %s -T ps_3_0 -E plain --target glsl450,glsl120,essl100,essl300,vulkan
// RUN: %draw compare %s -T ps_3_0 -E shapes --target glsl450,vulkan
// RUN: %draw compare %s -T ps_3_0 -E levels --target glsl450,glsl130,essl300,vulkan
// RUN: %draw compare %s -T ps_3_0 -E projected --target glsl450,glsl120,essl100,vulkan
// RUN: %draw compare %s -T ps_2_0 -E blocks --target glsl450,glsl120,essl100,vulkan
sampler2D map;
sampler lower_case;
samplerCUBE sky;
sampler3D volume;
sampler1D ramp;
texture picture;
sampler2D with_state = sampler_state {
  Texture = <picture>;
  MinFilter = Linear;
};
float4 tint;

float4 plain(float4 v : TEXCOORD0, float4 color : COLOR0) : COLOR {
  return tex2D(map, v.xy) * color + tex2D(lower_case, v.zw) * tint;
}
float4 shapes(float4 v : TEXCOORD0) : COLOR {
  return texCUBE(sky, v.xyz) + tex3D(volume, v.xyz) - tex1D(ramp, v.w) + texCUBElod(sky, v);
}
float4 levels(float4 v : TEXCOORD0) : COLOR {
  float4 c = tex2Dlod(map, float4(v.xy, 0, 1)) + tex2Dbias(map, float4(v.zw, 0, 0.25));
  return c - tex2Dgrad(lower_case, v.xy, ddx(v.zw), ddy(v.zw)) + tex2D(lower_case, v.xy, v.zw, v.yx);
}
float4 projected(float4 v : TEXCOORD0) : COLOR {
  float4 p = float4(v.xyz, 2);
  return tex2Dproj(map, p) + tex2Dproj(lower_case, float4(v.zw, 0, abs(v.x) + 1));
}
float4 Lookup(sampler2D s, float2 uv) { return tex2D(s, uv); }
float4 blocks(float2 uv : TEXCOORD0, float4 color : COLOR0) : COLOR0 { return Lookup(with_state, uv) * color + Lookup(map, uv.yx); }
