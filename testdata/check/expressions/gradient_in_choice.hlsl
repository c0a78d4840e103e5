// From 6.0 on `?:` of a scalar evaluates one side (dxc's "Logical Operation Short Circuiting"), so a sample or a derivative in it is in
// a branch. Before, and with -HV 2018, both sides are computed first.
// RUN: %clipc -T ps_6_0 -fsyntax-only %s 2>&1 | FileCheck %s --implicit-check-not=warning:
// RUN: %clipc -T ps_5_0 -fsyntax-only %s 2>&1 | count 0
// RUN: %clipc -T ps_6_0 -HV 2018 -fsyntax-only %s 2>&1 | count 0
Texture2D t;
SamplerState s;
float limit;
float4 main(float2 uv : TEXCOORD, nointerpolation int n : N) : SV_Target {
  // CHECK: [[#@LINE+1]]:29: warning: a sample uses differences between neighbouring pixels in flow that they may not share{{.*}} [-Wgradient-in-branch]
  float4 a = uv.x > limit ? t.Sample(s, uv * 3) : 0;
  // CHECK: [[#@LINE+1]]:32: warning: a derivative uses differences
  a.x += uv.y > limit ? uv.x : ddx(uv.x);
  a += limit > 2 ? t.Sample(s, uv) : 1;
  a += n > 2 ? t.Sample(s, uv) : ddy(uv.y);
  a += t.Sample(s, uv) * (uv.x > 1 ? 1 : 2);
  return a + (uv.x > limit ? t.SampleLevel(s, uv, 0) : 2);
}
