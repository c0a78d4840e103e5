// A matrix that is assigned to a cast of a larger one goes to the upper left corner, row by row. Oracle: vkd3d's
// lhs-partial-assignment.shader_test, checked against fxc.
// RUN: %clipc -T ps_5_0 %s -o - | FileCheck %s
// RUN: %draw compare %s -T ps_5_0
float2x3 small;

float4 main(float4 a : A) : SV_Target {
  float4x4 large = 7;
  // CHECK: large[0].xyz = temporary[0];
  // CHECK: large[1].xyz = temporary[1];
  (float2x3)large = small;
  return large[0] + 10 * large[1] + a * large[2];
}
