// What vertex shaders of Direct3D 9 lack. Oracles: fxc X3535, "Bitwise operations not supported on target ps_3_0"; Microsoft's page on
// tex2Dlod, shader model 3; fxc X4541, "vertex shader must minimally write all four components of POSITION".
// RUN: split-file %s %t
// RUN: not %clipc -T vs_3_0 -fsyntax-only %t/bits.hlsl 2>&1 | FileCheck %t/bits.hlsl
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
//--- texture.hlsl
sampler2D s;
float4 main(float4 p : POSITION) : POSITION {
  // CHECK: [[#@LINE+1]]:14: error: `tex2Dlod` needs profile vs_3_0 or later; this is `vs_2_a` [intrinsic-profile, X4532]
  return p + tex2Dlod(s, p);
}
//--- position.hlsl
// CHECK: [[#@LINE+1]]:8: error: the shader has no output `POSITION`; a vertex shader of Direct3D 9 writes all four components of one [position-missing, X4541]
float4 main(float4 p : POSITION) : COLOR0 { return p; }
