// A loop that counts is unrolled also where a condition that is not known decides whether it runs: vkd3d's unroll.shader_test, line 3, checked
// against fxc.
// RUN: %clipc -T ps_2_0 %s --validate -o - | FileCheck %s
// RUN: %draw compare %s -T ps_2_0 --target glsl120
float a;
float4 main() : COLOR {
  int i;
  if (a > 0) {
    // CHECK: for (i = 0; i < 10; ++i) {
    [unroll]
    for (i = 0; i < 10; ++i) ;
    return float4(i, a, 2, 3);
  }
  return float4(0, a, 3, 4);
}
