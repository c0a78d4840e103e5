// Multisampled textures, whose samples differ. Oracle: the evaluator.
// RUN: %draw compare %s -T ps_5_0 --target glsl450,glsl330,essl310,vulkan
// RUN: %draw compare %s -T ps_5_0 -E integers --target glsl450,essl310,vulkan
// RUN: %draw compare %s -T ps_5_0 -E queries --target glsl450,vulkan
// RUN: %draw compare %s -T vs_5_0 -E vertex --target glsl450,vulkan
// RUN: %draw compare %s -T ps_5_0 -E elements --target glsl450,glsl330,essl320,vulkan
// RUN: %draw compare %s -T ps_5_0 -E sizes --target glsl450,vulkan
// RUN: %draw compare %s -T vs_5_0 -E places --target glsl450,vulkan
Texture2DMS<float4> colors;
Texture2DMS<int2> counts;
Texture2DMSArray<float4> layers;
Texture2DMSArray<uint> numbers;
int2 Inside(int2 at) { return abs(at) % 3; }
float4 main(int2 at : AT, int number : NUMBER) : SV_Target {
  const int2 inside = Inside(at);
  return colors.Load(inside, 0) + colors.sample[1][inside].wzyx * 2 + colors.Load(inside, number & 3, int2(0, 0)) * 3 + colors[inside];
}
int2 integers(int2 at : AT, int number : NUMBER) : SV_Target {
  return counts.Load(Inside(at), number & 3) * 3 + counts.Load(0, 3);
}
float4 queries(int2 at : AT, uint number : NUMBER) : SV_Target {
  uint width, height, samples;
  colors.GetDimensions(width, height, samples);
  return colors.Load(uint2(abs(at)) % uint2(width, height), number % samples) * samples;
}
float4 vertex(int2 at : AT) : SV_Position { return colors.Load(Inside(at), 2); }

float4 elements(int2 at : AT, int number : NUMBER) : SV_Target {
  const int3 inside = int3(Inside(at), abs(number) % 3);
  return layers.Load(inside, number & 3) + layers.sample[1][inside].wzyx * 2 + layers.Load(inside, 3, int2(0, 0)) * 3 + layers[inside] +
         numbers.Load(inside, number & 3) % 100;
}
float4 sizes(int2 at : AT, uint number : NUMBER) : SV_Target {
  uint width, height, elements, samples;
  layers.GetDimensions(width, height, elements, samples);
  return layers.Load(uint3(abs(at), number) % uint3(width, height, elements), number % samples) * samples;
}
float4 places(int2 at : AT) : SV_Position { return layers.Load(int3(Inside(at), 2), 2); }
