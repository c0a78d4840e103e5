// RUN: %clipc -T vs_4_0 -E main %s -o - 2>&1 | FileCheck %s
// RUN: %clipc -T vs_4_0 -E main -Wno-clip-plane-repeated -Werror %s -o %t.vert
cbuffer Planes { float4 p; float4 q[2]; };
// CHECK: repeated.hlsl:[[#@LINE+2]]:22: warning: clip plane `p.xyzw` is given twice; once is enough
// CHECK: repeated.hlsl:[[#@LINE+1]]:13: note: first given here
[clipplanes(p, q[1], p.xyzw)]
float4 main(float4 v : POSITION) : SV_Position { return v; }
// CHECK: gl_ClipDistance[2] = dot(in_POSITION0, planes.p.xyzw);
