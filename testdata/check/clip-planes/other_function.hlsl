// RUN: %clipc -T vs_4_0 -E main %s -o - 2>&1 | FileCheck %s
cbuffer Planes { float4 p; };
// CHECK: other_function.hlsl:[[#@LINE+1]]:1: warning: `clipplanes` on `helper` is ignored; it has an effect only on the entry point [-Wclip-planes-not-on-entry]
[clipplanes(p)]
float4 helper(float4 v) { return v * 2; }
float4 main(float4 v : POSITION) : SV_Position { return helper(v); }
// CHECK-NOT: gl_ClipDistance
