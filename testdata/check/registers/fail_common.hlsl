// Two variables in one register c#. Oracle: vkd3d's register-reservations-numeric.shader_test, checked against native: refused from 4.0
// to 5.1 where one of them is used, in Direct3D 9 where both are; from 6.0 on they are aliased, but dxc -spirv refuses them (DXC's
// CodeGenSPIRV/cbuffer.overlap.hlsl), so that there is a warning where both are used.
// RUN: not %clipc -T vs_5_0 -Gec -E both -fsyntax-only %s 2>&1 | FileCheck %s
// RUN: not %clipc -T vs_5_0 -Gec -E one -fsyntax-only %s 2>&1 | FileCheck %s
// RUN: not %clipc -T vs_3_0 -E both -fsyntax-only %s 2>&1 | FileCheck %s
// RUN: %clipc -T vs_3_0 -E one -fsyntax-only %s 2>&1 | count 0
// RUN: %clipc -T vs_5_0 -Gec -E neither -fsyntax-only %s 2>&1 | count 0
// RUN: %clipc -T vs_6_0 -Gec -E both -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=SHARED --implicit-check-not=error:
// RUN: %clipc -T vs_6_0 -Gec -E one -fsyntax-only %s 2>&1 | count 0
// RUN: not %clipc -T vs_5_0 -Gec -E inside -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=INSIDE
// RUN: %clipc -T vs_3_0 -E inside -fsyntax-only %s 2>&1 | count 0
float4 a : register(c3);
// CHECK: [[#@LINE+3]]:8: error: `a` and `b` are both bound to register c3; each needs its own [register-twice, X4500]
// CHECK: [[#@LINE-2]]:8: note: `a` is declared here
// SHARED: [[#@LINE+1]]:8: warning: `a` and `b` are both bound to register c3 and share its memory, as in dxc for Direct3D; dxc for Vulkan and fxc report an error; each needs its own [-Wregister-shared]
float4 b : register(c3);
// In Direct3D 9 the elements that are used count: list[1] by its number, and every one of an index that only the running shader knows.
// RUN: not %clipc -T vs_3_0 -E second -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=INSIDE
// RUN: not %clipc -T vs_3_0 -E indexed -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=INSIDE
// RUN: not %clipc -T vs_3_0 -E by_uniform -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=INSIDE
// RUN: not %clipc -T ps_2_0 -E of_matrices -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=MATRICES
// RUN: %clipc -T vs_3_0 -E looped -Wno-loop-runs-once -fsyntax-only %s 2>&1 | count 0
// RUN: %clipc -T vs_3_0 -E only_second -fsyntax-only %s 2>&1 | count 0
float4 list[2] : register(c8);
// INSIDE: [[#@LINE+1]]:8: error: `list` and `last` are both bound to register c9
float4 last : register(c9);
float4 other : register(c5);
float4 both(float4 p : POSITION) : POSITION { return p * a + b; }
float4 one(float4 p : POSITION) : POSITION { return p * b; }
float4 neither(float4 p : POSITION) : POSITION { return p * other; }
float4 inside(float4 p : POSITION) : POSITION { return p * list[0] + last; }
float4 second(float4 p : POSITION) : POSITION { return p * list[1] + last; }
float4 indexed(float4 p : POSITION, int i : BLENDINDICES) : POSITION { return p * list[i] + last; }
int number : register(c20);
float4 by_uniform(float4 p : POSITION) : POSITION { return p * list[number] + last; }
// fxc unrolls the loop, and then uses list[0] alone.
float4 looped(float4 p : POSITION) : POSITION {
  for (int i = 0; i < 1; i++) p *= list[i];
  return p + last;
}
float4 only_second(float4 p : POSITION) : POSITION { return p * list[1]; }
float4x4 matrices[3] : register(c30);
// MATRICES: [[#@LINE+1]]:8: error: `matrices` and `after` are both bound to register c35
float4 after : register(c35);
float4 of_matrices(float4 p : TEXCOORD) : COLOR { return mul(p, matrices[2]) + after; }
