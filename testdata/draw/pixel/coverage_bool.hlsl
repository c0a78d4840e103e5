// fxc's `bool c : SV_Coverage` is the bit of the first sample: its listings mask the coverage with 1. DXC has no such bool.
// RUN: %clipc -T ps_5_0 %s --validate -o - | FileCheck %s
// RUN: %draw compare %s -T ps_5_0 --target glsl450
// CHECK: bool covered = (uint(gl_SampleMaskIn[0]) & 1u) != 0u;
float4 main(bool covered : SV_Coverage, float4 a : A) : SV_Target { return covered ? a : a.wzyx; }
// Of four samples a pixel on the edge between two triangles covers some in each, which the evaluator does not do: every API has them.
// RUN: %draw compare %s -T ps_5_0 -E mask --target glsl450,essl320,vulkan
// RUN: not %draw compare %s -T ps_5_0 -E mask --target glsl450 --samples 4 | FileCheck %s --check-prefix=EDGES
// RUN: not %draw compare %s -T ps_5_0 -E mask --target essl320 --samples 4 | FileCheck %s --check-prefix=EDGES
// RUN: not %draw compare %s -T ps_5_0 -E mask --target vulkan --samples 4 | FileCheck %s --check-prefix=EDGES
// EDGES: 250 wrong, 262 of 512 equal
float4 mask(uint covered : SV_Coverage, float4 a : A) : SV_Target { return a * covered; }
