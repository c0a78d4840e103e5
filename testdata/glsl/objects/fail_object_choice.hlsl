// An object that the shader would have to choose while it runs (fxc X3031; DXC: "local resource not guaranteed to map to unique
// global resource").
// RUN: not %clipc -T vs_5_0 %s -o %t 2>&1 | FileCheck %s
// AUTOUPDATE
Texture2D wood, stone;
SamplerState smooth;
struct Maps {
  Texture2D color;
};
// CHECK: fail_object_choice.hlsl:[[#@LINE+3]]:44: error: `maps.color` of type `Texture2D<float4>` is not one particular global; an object cannot be chosen at run time [object-not-global, X3031]
// CHECK-NEXT:    [[#@LINE+2]] | float4 Read(Maps maps, float2 uv) { return maps.color.SampleLevel(smooth, uv, 0); }
// CHECK-NEXT:       |                                            ^~~~~~~~~~
float4 Read(Maps maps, float2 uv) { return maps.color.SampleLevel(smooth, uv, 0); }
Texture2D Choose(bool first) {
  if (first) return wood;
// CHECK-NEXT: fail_object_choice.hlsl:[[#@LINE+3]]:3: error: `Choose()` of type `Texture2D<float4>` is not one particular global; an object cannot be chosen at run time [object-not-global, X3031]
// CHECK-NEXT:    [[#@LINE+2]] |   return stone;
// CHECK-NEXT:       |   ^~~~~~~~~~~~~
  return stone;
}

float4 main(float2 uv : TEXCOORD, bool first : FIRST) : SV_Position {
  Texture2D map;
  if (first) map = wood;
// CHECK-NEXT: fail_object_choice.hlsl:[[#@LINE+3]]:8: error: `map` of type `Texture2D<float4>` is not one particular global; an object cannot be chosen at run time [object-not-global, X3031]
// CHECK-NEXT:    [[#@LINE+2]] |   else map = stone;
// CHECK-NEXT:       |        ^~~~~~~~~~~
  else map = stone;
  Texture2D changed = wood;
// CHECK-NEXT: fail_object_choice.hlsl:[[#@LINE+3]]:31: error: `changed` of type `Texture2D<float4>` is not one particular global; an object cannot be chosen at run time [object-not-global, X3031]
// CHECK-NEXT:    [[#@LINE+2]] |   for (int k = 0; k < 2; ++k) changed = stone;
// CHECK-NEXT:       |                               ^~~~~~~~~~~~~~~
  for (int k = 0; k < 2; ++k) changed = stone;
  int i = uv.x;
  Maps empty;
  Maps both[2];
  both[0].color = wood;
  both[1].color = stone;
  return Read(empty, uv) + Choose(first).SampleLevel(smooth, uv, 0) + Read(both[i], uv);
}
