// "User clip planes on feature level 9 hardware", Syntax: a vertex shader target, and not below 4.0.
// RUN: not %clipc -T vs_3_0 %s -o - 2>&1 | FileCheck %s
// RUN: not %clipc -T vs_2_0 %s -o - 2>&1 | FileCheck %s
// RUN: not %clipc -T ps_4_0 %s -o - 2>&1 | FileCheck %s

cbuffer Clip { float4 plane; };

// CHECK: error: `clipplanes` is used under profile `{{.*}}`; it needs a vertex shader profile of 4.0 or later{{.*}} [clip-planes-profile]
[clipplanes(plane)]
float4 main(float4 position : POSITION) : SV_Position { return position; }
