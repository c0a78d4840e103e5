// What Direct3D 9 can be told is whole registers (fxc X4594), whether the profile or the lowering asks for it.
// RUN: not %clipc -T vs_4_0_level_9_1 -E main "-DPLANE=planes[0].wzyx" %s 2>&1 | FileCheck %s
// RUN: not %clipc -T vs_4_0_level_9_3 -E main "-DPLANE=f.xxxx" %s 2>&1 | FileCheck %s
// RUN: not %clipc -T vs_4_0_level_9_1 -E main "-DPLANE=m[0]" %s 2>&1 | FileCheck %s
// RUN: not %clipc -T vs_4_0_level_9_1 -E main "-DPLANE=float4(planes[0].xyz, f)" %s 2>&1 | FileCheck %s
// RUN: not %clipc -T vs_5_0 --lower=level9 -E main "-DPLANE=f.xxxx" %s 2>&1 | FileCheck %s
// CHECK: is not one whole `float4` register in its own order; Direct3D 9 accepts only whole registers [clip-plane-not-whole-register, X4594]
cbuffer Planes { float4 planes[2]; float4x4 m; float f; };
[clipplanes(PLANE)]
float4 main(float4 v : POSITION) : SV_Position { return v; }
