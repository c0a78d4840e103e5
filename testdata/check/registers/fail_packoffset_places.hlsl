// Places of packoffset: DXC's packreg.hlsl and semantics.hlsl have what fxc says of each.
// RUN: not %clipc -T vs_5_0 -E wrong %s 2>&1 | grep -v '^ ' | FileCheck %s
// RUN: %clipc -T vs_5_0 -E wrong -DMIXED %s -o - 2>&1 | FileCheck %s --check-prefix=MIXED
// MIXED: [[#@LINE+3]]:46: warning: this `packoffset` overrides
cbuffer Block {
  // CHECK-DAG: [[#@LINE+1]]:46: warning: this `packoffset` overrides the one before it [-Wpack-offset-overridden]
  float4 a : packoffset(c4) : ANY_SEMANTIC : packoffset(c5);
  // CHECK-DAG: [[#@LINE-1]]:14: note: first given here
  float4 b : packoffset(c6) : packoffset(c6.x);
  Texture2D none;
  // MIXED: [[#@LINE+1]]:10: warning: `c` has no `packoffset`, and other members of its buffer have one; it follows the last of those, fxc reports an error [-Wpack-offset-mixed]
  float4 c;
  float4 d;
}
#ifndef MIXED
// CHECK-DAG: [[#@LINE+1]]:12: error: `packoffset` is for members of constant buffers [pack-offset-misplaced, X3091]
float4 e : packoffset(c0);
// CHECK-DAG: [[#@LINE+1]]:23: error: `packoffset` is for members of constant buffers
struct S { float4 f : packoffset(c0); };
// CHECK-DAG: [[#@LINE+1]]:24: error: `packoffset` is for members of constant buffers
SamplerState reading : packoffset(c0);
S s;
#endif
// MIXED: layout(offset = 80) vec4 a;
// MIXED-NEXT: vec4 b;
// MIXED-NEXT: vec4 c;
// MIXED-NEXT: vec4 d;
float4 wrong(float4 p : P) : SV_Position { return a + b + c + d + none.Load(0); }
