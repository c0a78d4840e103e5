// Offsets that nothing makes known, and one that is too far: fxc X4566. One call of a function gives no constant.
// RUN: not %clipc -T vs_5_0 %s -o %t 2>&1 | FileCheck %s
// AUTOUPDATE
Texture2D map; SamplerState s; int k;
// CHECK: fail_texture_offsets.hlsl:[[#@LINE+3]]:65: error: the offset given to `SampleLevel` is not constant; it must be known at compile time [texture-offset-not-constant, X4566]
// CHECK-NEXT:     [[#@LINE+2]] | float4 Tap(float2 uv, int x) { return map.SampleLevel(s, uv, 0, int2(x, 0)); }
// CHECK-NEXT:       |                                                                 ^~~~~~~~~~
float4 Tap(float2 uv, int x) { return map.SampleLevel(s, uv, 0, int2(x, 0)); }
float4 main(float2 uv : TEXCOORD) : SV_Position {
  const int2 away = int2(9, 0);
// CHECK-NEXT: fail_texture_offsets.hlsl:[[#@LINE+3]]:66: error: offset 9 is given to `SampleLevel`; it must be from -8 to 7 [texture-offset-range, X4566]
// CHECK-NEXT:    [[#@LINE+2]] |   float4 r = Tap(uv, 1) + Tap(uv, k) + map.SampleLevel(s, uv, 0, away);
// CHECK-NEXT:       |                                                                  ^~~~
  float4 r = Tap(uv, 1) + Tap(uv, k) + map.SampleLevel(s, uv, 0, away);
// CHECK-NEXT: fail_texture_offsets.hlsl:[[#@LINE+3]]:62: error: the offset given to `SampleLevel` is not constant; it must be known at compile time [texture-offset-not-constant, X4566]
// CHECK-NEXT:    [[#@LINE+2]] |   for (int i = 0; i < k; ++i) r += map.SampleLevel(s, uv, 0, int2(i, 0));
// CHECK-NEXT:       |                                                              ^~~~~~~~~~
  for (int i = 0; i < k; ++i) r += map.SampleLevel(s, uv, 0, int2(i, 0));
  int2 o = int2(k, 1);
  // What changes something is not left out with the components that are.
// CHECK-NEXT: fail_texture_offsets.hlsl:[[#@LINE+3]]:34: error: the offset given to `SampleLevel` is not constant; it must be known at compile time [texture-offset-not-constant, X4566]
// CHECK-NEXT:    [[#@LINE+2]] |   r += map.SampleLevel(s, uv, 0, int3(1, 2, o.x++).xy);
// CHECK-NEXT:       |                                  ^~~~~~~~~~~~~~~~~~~~
  r += map.SampleLevel(s, uv, 0, int3(1, 2, o.x++).xy);
  return r;
}
