// msad4 comes with shader model 5.
// RUN: not %clipc -T vs_4_0 -E main %s -o - 2>&1 | FileCheck %s

float4 main(float4 p : POSITION, uint4 q : BLENDINDICES) : SV_Position {
  // CHECK: fail_msad4_model.hlsl:[[#@LINE+1]]:14: error: {{.*}}`msad4`
  return p + msad4(q.x, q.yz, q);
}
