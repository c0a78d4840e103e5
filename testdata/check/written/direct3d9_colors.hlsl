// Direct3D 9 clamps colors; one that nothing writes is named all the same (fxc X3578).
// RUN: %clipc -T vs_2_0 -fsyntax-only %s 2>&1 | FileCheck %s --implicit-check-not=warning:
// CHECK: [[#@LINE+2]]:47: warning: the output `c` is never written; the next stage reads what is undefined [-Woutput-not-written]
// CHECK: [[#@LINE+1]]:70: warning: the output `d` is not written on every path
void main(float4 p : POSITION, out float4 c : COLOR0, out float4 d : COLOR1, out float fog : FOG, out float4 q : POSITION) {
  q = p;
  fog = p.z;
  if (p.x > 1) d = p;
}
