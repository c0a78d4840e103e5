// Textures: samples, gathers, loads and sizes, pairs of textures and samplers, arrays of textures.
// RUN: %draw compare %s -T vs_5_0 -E samples --target glsl450,glsl410,glsl330,essl300 -D PLAIN --lower none
// RUN: %draw compare %s -T vs_5_0 -E samples --target glsl450,glsl330 --lower none --seed 2
// RUN: %draw compare %s -T vs_5_0 -E compares --target glsl450,glsl410,essl310 --lower none
// RUN: %draw compare %s -T vs_5_0 -E gathers --target glsl450,glsl400,essl310,essl320 --lower none
// RUN: %draw compare %s -T vs_5_0 -E loads --target glsl450,glsl130 --lower none --ints 0..3
// RUN: %draw compare %s -T vs_5_0 -E sizes --target glsl450,glsl430 --lower none --ints 0..2
// RUN: %draw compare %s -T vs_5_0 -E arrays --target glsl450,glsl400,essl320 --lower none
// RUN: %draw compare %s -T vs_5_0 -E arrays --target glsl330,essl300 --lower none -D WITHOUT_INDEX
// RUN: %draw compare %s -T vs_5_0 -E parameters --target glsl450,essl310 --lower none --ints 0..4
// RUN: %draw compare %s -T vs_5_0 -E samples --target vulkan --lower none
// RUN: %draw compare %s -T vs_5_0 -E compares --target vulkan --lower none
// RUN: %draw compare %s -T vs_5_0 -E gathers --target vulkan --lower none
// RUN: %draw compare %s -T vs_5_0 -E loads --target vulkan --lower none --ints 0..3
// RUN: %draw compare %s -T vs_5_0 -E sizes --target vulkan --lower none --ints 0..2
// RUN: %draw compare %s -T vs_5_0 -E arrays --target vulkan --lower none
// RUN: %draw compare %s -T vs_5_0 -E parameters --target vulkan --lower none --ints 0..4
// RUN: %draw compare %s -T vs_3_0 -E old --target vulkan --lower none
// RUN: %draw compare %s -T vs_3_0 -E old --target glsl450,glsl130,glsl120 --lower none

Texture2D<float4> colors : register(t0);
Texture2DArray<float4> layers : register(t1);
Texture3D<float3> volume : register(t2);
TextureCube<float4> sky : register(t3);
Texture2D<float> heights : register(t4);
Texture2D<int4> numbers : register(t5);
Texture3D<uint2> cells : register(t6);
Texture2DArray<float2> pages : register(t7);
Texture2D maps[3] : register(t8);
#ifndef PLAIN
Texture1D<float4> ramp : register(t11);
Texture1DArray<float4> ramps : register(t12);
TextureCubeArray<float4> skies : register(t13);
#endif
SamplerState smooth, sharp;
SamplerComparisonState nearer;

struct Output {
  float4 position : SV_Position;
  float4 a : A;
  float4 b : B;
  float4 c : C;
};

Output samples(float4 p : POSITION) {
  Output result;
  result.position = colors.SampleLevel(smooth, p.xy, p.z);
  result.a = layers.SampleLevel(sharp, p.xyz, p.w) * p + colors.SampleLevel(sharp, p.yx, 1, int2(2, -3));
  result.b = float4(volume.SampleGrad(smooth, p.xyz, p.zyx, p.yyx), heights.SampleLevel(smooth, p.zw, 0));
  result.c = sky.SampleLevel(smooth, p.xyz, 0).wzyx;
#ifndef PLAIN
  result.c += ramp.SampleLevel(smooth, p.x, p.y) - ramps.SampleLevel(sharp, p.xy, p.z) * skies.SampleLevel(smooth, p, 0);
#endif
  return result;
}

// The pair of a texture with a comparison sampler is another variable in GLSL than that with a plain one.
Output compares(float4 p : POSITION) {
  Output result;
  result.position = heights.SampleCmpLevelZero(nearer, p.xy, p.z);
  result.a = heights.SampleLevel(smooth, p.xy, 0) + heights.SampleCmpLevelZero(nearer, p.xy, p.w, int2(1, 2));
  result.b = p.x * layers.SampleCmpLevelZero(nearer, p.xyz, p.y);
  result.c = sky.SampleCmpLevelZero(nearer, p.xyz, p.w * 0.5);
  return result;
}

Output gathers(float4 p : POSITION) {
  Output result;
  result.position = colors.Gather(smooth, p.xy);
  result.a = colors.GatherAlpha(smooth, p.yz, int2(1, -1)) * p;
  result.b = layers.GatherGreen(sharp, p.xyz) + heights.GatherRed(sharp, p.xy);
  result.c = colors.GatherBlue(smooth, p.zw, int2(0, 1), int2(1, 0), int2(-2, 3), int2(4, 4));
  return result;
}

Output loads(int4 p : POSITION, uint4 q : Q) {
  Output result;
  result.position = heights.Load(p.xyz);
  result.a = numbers.Load(int3(q.xy, 0)) + numbers[q.zw];
  result.b = float4(cells.Load(p.zyxw), cells[q.xyz]);
  result.c = float4(pages.Load(int4(p.xyz, 1)), pages.Load(int4(q.wzy, 0), int2(1, 1)));
  return result;
}

// The levels are the same for all vertices: Mesa 22.3 takes that of one vertex for several.
uint2 level;

// Not part of OpenGL ES: the number of levels.
Output sizes(int2 p : POSITION) {
  Output result = (Output)0;
  uint width, height, depth, levels;
  colors.GetDimensions(width, height);
  result.position = float4(width, height, p);
  layers.GetDimensions(level.x, width, height, depth, levels);
  result.a = float4(width, height, depth, levels);
  volume.GetDimensions(1, width, height, depth, levels);
  result.b = float4(width, height, depth, levels);
  sky.GetDimensions(level.y, width, height, levels);
  result.c = float4(width, height, levels, p.x);
#ifndef PLAIN
  ramps.GetDimensions(width, height);
  result.c.w += 100 * width + height;
#endif
  return result;
}

Output arrays(float4 p : POSITION) {
  Output result;
  result.position = maps[0].SampleLevel(smooth, p.xy, 0);
  result.a = maps[2].SampleLevel(smooth, p.xy, 0) * p;
  result.b = 0;
#ifndef WITHOUT_INDEX
  for (int i = 0; i < 3; ++i) result.b += (i + 1) * maps[i].SampleLevel(sharp, p.zw, 0);
#endif
  result.c = p;
  return result;
}

Texture2D<uint> ids[2][3] : register(t20);

float4 fetch(Texture2D<float4> from, SamplerState how, float2 uv, uint2 at) {
  return from.SampleLevel(how, uv, 1) + from[at].wzyx * 4;
}

// Arguments are evaluated from left to right, once.
Output parameters(float4 p : POSITION, uint4 q : Q) {
  Output result;
  int i = 0;
  result.position = fetch(colors, smooth, p.xy, q.xy) - fetch(maps[1], sharp, p.zw, q.zw);
  result.a = colors.Load(int3(i++, i++, 0)) + maps[2].Load(int3(i++, i++, 0));
  result.b = colors.SampleLevel(smooth, p.xy += 0.3, 0) + i;
  result.c = float4(ids[1][2][q.xy], ids[0][1].Load(int3(q.zw, 0)), p.xy);
  return result;
}

sampler2D old_color;
sampler3D old_volume;
samplerCUBE old_sky;

struct OldOutput {
  float4 position : POSITION;
  float4 a : TEXCOORD0;
  float4 b : TEXCOORD1;
};

OldOutput old(float4 p : POSITION) {
  OldOutput result;
  result.position = tex2Dlod(old_color, p);
  result.a = tex3Dlod(old_volume, p.wzyx) * p;
  result.b = texCUBElod(old_sky, p) - tex2Dlod(old_color, p.yxwz);
  return result;
}
