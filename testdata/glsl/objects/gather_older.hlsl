// Before GLSL 4.00 a gather is an extension: of the first component in GL_ARB_texture_gather from 1.30 on, of the others, compared or
// with offsets that vary in GL_ARB_gpu_shader5 from 1.50 on.
// RUN: %clipc -T ps_5_0 %s --target=glsl130 --validate -o - | FileCheck %s --implicit-check-not=GL_ARB_gpu_shader5
// RUN: %clipc -T ps_5_0 -E more %s --target=glsl330 --validate -o - | FileCheck %s --check-prefix=MORE
// RUN: %clipc -T ps_5_0 -E more %s --target=glsl150 --validate -o - | FileCheck %s --check-prefix=MORE
// RUN: %draw compare %s -T ps_5_0 --target=glsl130,glsl330
// RUN: %draw compare %s -T ps_5_0 -E components --target=glsl150,glsl330
Texture2D map;
Texture2DArray layers;
TextureCube sky;
Texture2D<int2> numbers;
SamplerState s;
SamplerComparisonState c;
int2 o;
// CHECK: #extension GL_ARB_texture_gather : require
float4 main(float4 p : P) : SV_Target {
  // CHECK: textureGather(map, vs_P0.xy) + textureGatherOffset(map, vs_P0.xy, ivec2(1, -2))
  float4 r = map.Gather(s, p.xy) + map.GatherRed(s, p.xy, int2(1, -2));
  r += layers.Gather(s, p.xyz) + sky.Gather(s, p.xyz) + numbers.Gather(s, p.xy);
  // CHECK: vec4(textureGatherOffset(map, vs_P0.xy, ivec2(0)).x, textureGatherOffset(map, vs_P0.xy, ivec2(1, 0)).y,
  return r + map.Gather(s, p.xy, int2(0, 0), int2(1, 0), int2(0, 1), int2(1, 1));
}
// MORE: #extension GL_ARB_gpu_shader5 : require
float4 more(float4 p : P) : SV_Target {
  // MORE: textureGather(map_s, vs_P0.xy, 1) + textureGather(map_s, vs_P0.xy, 2)
  float4 r = map.GatherGreen(s, p.xy) + map.GatherBlue(s, p.xy) + map.GatherAlpha(s, p.xy, int2(2, 1));
  r += map.GatherCmp(c, p.xy, p.z);
  r += map.Gather(s, p.xy, o & 3);
  return r + map.GatherGreen(s, p.xy, int2(0, 0), int2(1, 0), int2(0, 1), int2(1, 1));
}

float4 components(float4 p : P) : SV_Target {
  return map.GatherGreen(s, p.xy) + map.GatherBlue(s, p.xy) * 2 + map.GatherAlpha(s, p.xy, int2(2, 1)) * 3;
}
