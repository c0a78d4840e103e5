// What vertex shaders of Direct3D 9 lack. Oracles: fxc X3535, "Bitwise operations not supported on target ps_3_0"; X3511 of Microsoft's page
// of HLSL's errors, since vs_2_0 has instructions for loops to an integer constant only; Microsoft's page on tex2Dlod, shader model 3; fxc X4541, "vertex shader must minimally write all four components of POSITION".
// RUN: split-file %s %t
// RUN: not %clipc -T vs_3_0 -fsyntax-only %t/bits.hlsl 2>&1 | FileCheck %t/bits.hlsl
// RUN: not %clipc -T vs_2_0 -fsyntax-only %t/loops.hlsl 2>&1 | FileCheck %t/loops.hlsl
// RUN: not %clipc -T vs_1_1 -fsyntax-only %t/loops.hlsl 2>&1 | FileCheck %t/loops.hlsl --check-prefixes=CHECK,VS11
// RUN: %clipc -T vs_2_a -fsyntax-only %t/loops.hlsl 2>&1 | count 0
// RUN: not %clipc -T vs_2_a -fsyntax-only %t/texture.hlsl 2>&1 | FileCheck %t/texture.hlsl
// RUN: %clipc -T vs_3_0 -fsyntax-only %t/texture.hlsl 2>&1 | count 0
// RUN: not %clipc -T vs_2_0 -fsyntax-only %t/position.hlsl 2>&1 | FileCheck %t/position.hlsl
//--- bits.hlsl
int n;
float4 main(float4 p : POSITION) : POSITION {
  // CHECK: [[#@LINE+1]]:11: error: a bit operation is used; `vs_3_0` has no integer instructions [level9-bit-operation, X3535]
  int a = n & 3;
  // CHECK: [[#@LINE+1]]:3: error: a bit operation is used
  a <<= 1;
  int b = 4 | 1;
  for (int i = 0; i < 4; ++i) b += i & 1;
  return p * a + b;
}
//--- loops.hlsl
int count;
float4 main(float4 p : POSITION) : POSITION {
  float4 sum = p;
  // CHECK: [[#@LINE+1]]:19: error: only the running shader knows how often the loop runs; `vs_{{.*}}` has no such loops [level9-unknown-loop, X3511]
  for (int i = 0; i < p.x; ++i) sum += p;
  // CHECK: [[#@LINE+1]]:10: error: only the running shader knows
  while (sum.x < 3) sum += p;
  for (int j = 0; j < 4; ++j) sum += j;
  // VS11: [[#@LINE+1]]:19: error: only the running shader knows
  for (int k = 0; k < count; ++k) sum += p;
  // CHECK-NOT: error:
  return sum;
}
//--- texture.hlsl
sampler2D s;
float4 main(float4 p : POSITION) : POSITION {
  // CHECK: [[#@LINE+1]]:14: error: `tex2Dlod` needs profile vs_3_0 or later; this is `vs_2_a` [intrinsic-profile, X4532]
  return p + tex2Dlod(s, p);
}
//--- position.hlsl
// CHECK: [[#@LINE+1]]:8: error: the shader has no output `POSITION`; a vertex shader of Direct3D 9 writes all four components of one [position-missing, X4541]
float4 main(float4 p : POSITION) : COLOR0 { return p; }
