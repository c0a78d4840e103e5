// There is one near plane.
// RUN: not %clipc -T vs_5_0 --lower=near-plane %s -o %t 2>&1 | FileCheck %s
float4 water, portal;
// CHECK: fail_near_plane_count.hlsl:[[#@LINE+1]]:20: error: the shader has 2 clip planes; the lowering `near-plane` supports one, in place of the near plane [clip-planes-for-near-plane]
[clipplanes(water, portal)]
float4 main(float4 position : POSITION) : SV_Position { return position; }
