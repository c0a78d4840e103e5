// An offset is known when its components are, whatever the others of the same vector.
// RUN: %clipc -T vs_5_0 --target=glsl450 --verify --validate %s -o - | FileCheck %s
// RUN: %draw compare %s -T vs_5_0 --target glsl450,vulkan --ints 0..3
Texture2D map;
SamplerState s;
int n;  // one of --ints
float4 Tap(float2 uv, int2 o) {
  const int4 both = {o, n, o.y};
  return map.SampleLevel(s, uv, 0, both.wx);
}
float4 main(float2 uv : TEXCOORD) : SV_Position {
  // CHECK: textureLodOffset(map, uv, 0.0, ivec2(-3, 2))
  int4 a = {1, 0, 3, n};
  int3 b = int3(a.w, a.zx);
  // CHECK: texelFetchOffset(map, ivec2(0), 0, ivec2(1, 0))
  float4 r = map.Load(int3(0, 0, 0), a.xy);
  // CHECK: textureLodOffset(map, in_TEXCOORD0, 0.0, ivec2(3, 1))
  r += map.SampleLevel(s, uv, 0, b.yz) + Tap(uv, int2(2, -3));
  // CHECK: texelFetchOffset(map, ivec2(1), 0, ivec2(-1))
  return r + map.Load(int3(1, 1, 0), int2(n, -1).yy) + a.w;
}
