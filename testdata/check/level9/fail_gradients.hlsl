// Derivatives before 3.0. Oracle: Microsoft's page on D3DXGetPixelShaderProfile, by which ps_2_a alone of the profiles 2_x has
// GradientInstructions.
// RUN: not %clipc -T ps_2_0 -fsyntax-only %s 2>&1 | FileCheck %s
// RUN: not %clipc -T ps_2_b -fsyntax-only %s 2>&1 | FileCheck %s
// RUN: %clipc -T ps_2_a -fsyntax-only %s 2>&1 | count 0
// RUN: %clipc -T ps_3_0 -fsyntax-only %s 2>&1 | count 0
float4 main(float2 p : TEXCOORD0) : COLOR {
  // CHECK: [[#@LINE+1]]:17: error: `ddx` needs profile ps_2_a or ps_3_0 or later; this is `ps_2_{{.}}` [intrinsic-profile, X4532]
  return float4(ddx(p), fwidth(p));
}
