// Local variables have no semantics: fxc X3043, and an error of DXC's; SemaHLSL/semantics.hlsl of its tests names both. Parameters of
// functions that are not entered may have them.
// RUN: not %clipc -T vs_5_0 %s 2>&1 | FileCheck %s
float4 f(float4 x : TEXCOORD0) : ANY { return x; }
float4 main(float4 p : POSITION) : SV_Position {
  // CHECK: [[#@LINE+1]]:14: error: the local variable `q` has the semantic `TEXCOORD0`; only inputs, outputs and their fields have one; remove it [semantic-on-local, X3043]
  float4 q : TEXCOORD0 = p;
  // CHECK: [[#@LINE+1]]:16: error: the local variable `i` has the semantic `INDEX`
  for (int i : INDEX = 0; i < 2; ++i) q += i;
  return f(q);
}
