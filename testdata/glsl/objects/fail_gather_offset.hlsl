// Before 5.0 the offset of a Gather must be known.
// RUN: not %clipc -T vs_4_1 %s -o %t 2>&1 | FileCheck %s
// AUTOUPDATE
Texture2D map; SamplerState s; int2 away;
// CHECK: fail_gather_offset.hlsl:[[#@LINE+3]]:76: error: the offset given to `Gather` is not constant; it must be known at compile time [texture-offset-not-constant, X4566]
// CHECK-NEXT:     [[#@LINE+2]] | float4 main(float2 uv : TEXCOORD) : SV_Position { return map.Gather(s, uv, away); }
// CHECK-NEXT:       |                                                                            ^~~~
float4 main(float2 uv : TEXCOORD) : SV_Position { return map.Gather(s, uv, away); }
