// Members of a constant buffer with components in common. Oracles: vkd3d's cbuffer.shader_test, checked against native ("elements cannot
// overlap if buffer is used"); DXC's and Clang's tests of packoffset, "packoffset overlap between".
// RUN: not %clipc -T vs_5_0 -Gec -E scalars -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=SCALARS
// RUN: not %clipc -T vs_6_0 -Gec -E scalars -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=SCALARS
// RUN: not %clipc -T ps_4_0 -E matrices -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=MATRICES
// RUN: not %clipc -T vs_5_1 -E arrays -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=ARRAYS
// RUN: not %clipc -T vs_5_0 -E structs -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=STRUCTS
// RUN: not %clipc -T vs_5_0 -E tbuffers -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=TBUFFERS
// RUN: not %clipc -T vs_3_0 -E both -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=SCALARS
// RUN: %clipc -T vs_3_0 -E scalars -fsyntax-only %s 2>&1 | count 0
// RUN: %clipc -T vs_5_0 -Gec -E unused -fsyntax-only %s 2>&1 | count 0
// RUN: %clipc -T vs_5_0 -E apart -fsyntax-only %s 2>&1 | count 0
cbuffer Scalars {
  float4 all : packoffset(c0);
  // SCALARS: [[#@LINE+2]]:9: error: `part` at c0.y overlaps `all`, which has c0.x to c0.w; each member of a constant buffer has components of its own [pack-offset-overlap, X4019]
  // SCALARS: [[#@LINE-2]]:10: note: `all` is declared here
  float part : packoffset(c0.y);
};
cbuffer Matrices {
  float4 late : packoffset(c6);
  // MATRICES: [[#@LINE+1]]:10: error: `inner` at c3.x overlaps `whole`, which has c1.x to c4.w
  float2 inner : packoffset(c3);
  float4x4 whole : packoffset(c1);
};
cbuffer Arrays {
  float list[3] : packoffset(c0);
  // The last element leaves three components free.
  float3 rest : packoffset(c2.y);
  // ARRAYS: [[#@LINE+1]]:9: error: `between` at c1.y overlaps `list`, which has c0.x to c2.x
  float between : packoffset(c1.y);
};
struct Pair { float3 a; float2 b; };
cbuffer Structs {
  Pair pair : packoffset(c0);
  float free : packoffset(c1.z);
  // STRUCTS: [[#@LINE+1]]:9: error: `taken` at c1.y overlaps `pair`, which has c0.x to c1.y
  float taken : packoffset(c1.y);
};
tbuffer Tbuffer {
  uint2 number : packoffset(c0);
  // TBUFFERS: [[#@LINE+1]]:8: error: `same` at c0.x overlaps `number`, which has c0.x to c0.y
  uint same : packoffset(c0.x);
};
cbuffer Apart {
  float2x3 wide : packoffset(c0);
  float gap : packoffset(c2.z);
  float3 left : packoffset(c4);
  float right : packoffset(c4.w);
};
float4 scalars(float4 p : POSITION) : POSITION { return p * all; }
float4 both(float4 p : POSITION) : POSITION { return p * all + part; }
float4 matrices(float4 p : POSITION) : SV_Target { return mul(p, whole); }
float4 arrays(float4 p : POSITION) : POSITION { return p * list[1]; }
float4 structs(float4 p : POSITION) : POSITION { return p * taken; }
float4 tbuffers(float4 p : POSITION) : POSITION { return p * same; }
float4 unused(float4 p : POSITION) : POSITION { return p; }
float4 apart(float4 p : POSITION) : SV_Position { return float4(mul(p.xy, wide), gap) + right + left.xyzx; }
