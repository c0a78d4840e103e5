// A static texture is the one that a function assigns to it: vkd3d's static-initializer.shader_test, line 180. What a branch that never runs
// reads has no meaning, line 89.
// RUN: %clipc -T ps_5_0 %s --validate -o - | FileCheck %s
// RUN: %draw compare %s -T ps_5_0
Texture2D real;
SamplerState s;
static Texture2D later, never;
struct Maps { Texture2D color; float scale; };
static Maps maps;
// CHECK: vec4 Read
// CHECK: texelFetch(real
float4 Read(int2 p) { return later[p] * maps.scale; }
float4 main(int2 at : AT) : SV_Target {
  const int2 p = at & 1;
  later = real;
  maps.color = later;
  maps.scale = 2;
  if (0) return never.Load(0);
  return Read(p) + maps.color[p + 1];
}
