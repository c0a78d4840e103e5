// A struct with textures converts to one with the same textures at the same places. Oracle: vkd3d's
// cast-componentwise-compatible.shader_test, lines 62 and 93, and cast-componentwise-equal.shader_test, lines 96 and 127, checked
// against fxc.
// RUN: %clipc -T ps_5_0 --validate --verify %s -o - | FileCheck %s
// RUN: %draw compare %s -T ps_5_0
Texture2D map;
SamplerState linear_sampler;
struct Long { int2 a; Texture2D t; float c; float4 d; SamplerState s; };
struct Short { float a[2]; Texture2D t; int c; };
struct Same { int a[2]; Texture2D u; float c; float d[4]; SamplerState s; };
float4 Read(Same same, float2 uv) { return same.u.Sample(same.s, uv) * same.c; }
float4 main(float2 uv : TEXCOORD) : SV_Target {
  Long whole = { 1, 2, map, 7.2, 4, 5, 6, 7, linear_sampler };
  Short cut = (Short)whole;
  Same same = whole;
  // CHECK: texture(map,
  return Read(whole, uv) + cut.t.Sample(same.s, uv) + cut.c + cut.a[1] + same.d[3];
}
