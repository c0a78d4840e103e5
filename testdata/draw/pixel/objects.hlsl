// Objects that are found where they are used: structs with nothing but objects in them (DXC's vk.binding.global-struct-of-resources),
// results chosen by an index that is known at run time (DXC's type.rwtexture.load.function.return) or by a constant argument
// (legal-examples/20-multi-func-ret-const-ok), elements of a global array of structs in a loop, and branches that constants decide.
// RUN: %draw compare %s -T ps_5_1 --target=glsl450,vulkan
// RUN: %clipc -T ps_5_1 %s | FileCheck %s
struct Maps {
  Texture2D map;
  SamplerState smooth;
  float4 Get(float2 uv) { return map.SampleLevel(smooth, uv, 0); }
};
struct Material {
  Texture2D map;
  SamplerState smooth;
  float4 scale;
};
struct Chosen {
  Texture2D map;
  float weight;
};
Maps maps, pairs[2];
Material materials[2];
Texture2D many[4], wood, stone;
SamplerState smooth;
cbuffer Frame {
  float4 tint;
  Maps framed;
};
uint which;
static const bool kIsWood = false;

// Where nothing is left of a value, there is neither an argument nor a variable.
// CHECK: vec4 Read(vec2 uv) {
float4 Read(Maps from, float2 uv) { return from.map.SampleLevel(from.smooth, uv, 0); }
float4 Scaled(Material from, float2 uv) { return from.map.SampleLevel(from.smooth, uv, 0) * from.scale; }

// CHECK: void Find(uint i, out uint many_index) {
Texture2D Find(uint i) { return many[i & 3]; }
Texture2D Next(uint i, bool is_next) {
  if (is_next) return many[(i + 1) & 3];
  return many[i & 3];
}
Chosen FindBoth(uint i) {
  Chosen both;
  both.map = many[i & 3];
  both.weight = i;
  return both;
}
Texture2D Either(bool is_wood) {
  if (is_wood) return wood;
  else return stone;
}
float4 Mixed(bool is_wood, float2 uv) {
  Texture2D map = is_wood ? wood : stone;
  return map.SampleLevel(smooth, uv, 0);
}

float4 main(float2 uv : UV, float2 more : MORE) : SV_Target {
  Maps copy = maps;
  float4 sum = Read(maps, uv) + copy.Get(uv) * 2 + Read(pairs[1], uv) + pairs[0].Get(more) + Read(framed, uv) * tint;
  for (int i = 0; i < 2; i++) sum += materials[i].map.SampleLevel(materials[i].smooth, uv, 0) * materials[i].scale;
  for (int k = 0; k < 2; k++) sum += Scaled(materials[k], more);
  Chosen both = FindBoth(which + 2);
  sum += Find(which).SampleLevel(smooth, uv, 0) - Find(3).SampleLevel(smooth, uv, 0) + Next(which, which > 2).SampleLevel(smooth, uv, 0);
  sum += both.map.SampleLevel(smooth, uv, 0) * both.weight + FindBoth(which).map.SampleLevel(smooth, more, 0);
  sum += Either(true).SampleLevel(smooth, uv, 0) * 3 + Either(false).SampleLevel(smooth, uv, 0);
  Texture2D last = stone;
  if (kIsWood) last = wood;
  return sum + Mixed(true, uv) * 5 - Mixed(false, more) + last.SampleLevel(smooth, more, 0);
}
