// A register space before 5.1. Oracle: fxc X3721, "space is only supported for shader targets 5.1 and higher", of space0 too.
// RUN: not %clipc -T vs_5_0 -fsyntax-only %s 2>&1 | FileCheck %s
// RUN: %clipc -T vs_5_1 -fsyntax-only %s 2>&1 | count 0
// CHECK-DAG: [[#@LINE+1]]:13: error: `C` has a register space; profiles before vs_5_1 have none, and this is `vs_5_0` [space-profile, X3721]
cbuffer C : register(b0, space1) {
  float4 a;
};
// CHECK-DAG: [[#@LINE+1]]:15: error: `t` has a register space
Texture2D t : register(t0, space0);
float4 main(float4 p : POSITION) : SV_Position { return p * a + t.Load(0); }
