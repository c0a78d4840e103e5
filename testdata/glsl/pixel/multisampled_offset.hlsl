// `Load(location, sample, offset)` of a multisampled texture: GLSL has no texelFetchOffset of a sampler2DMS.
// RUN: %clipc -T ps_5_0 %s -o - --validate | FileCheck %s
// RUN: %clipc -T ps_5_0 %s -o - --validate --target=vulkan | FileCheck %s
Texture2DMS<float4> samples;
Texture2DMSArray<float4> layers;
float4 main(float4 position : SV_Position) : SV_Target {
  int2 place = position.xy;
  // CHECK: texelFetch({{.*}}, place + ivec2(1, -2), 0)
  // CHECK-SAME: texelFetch({{.*}}, ivec3(place, 3) + ivec3(ivec2(2, 1), 0), 1)
  return samples.Load(place, 0, int2(1, -2)) + layers.Load(int3(place, 3), 1, int2(2, 1));
}
