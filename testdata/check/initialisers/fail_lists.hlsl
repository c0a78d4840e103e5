// RUN: not %clipc -T vs_5_0 -E main %s 2>&1 | FileCheck %s
SamplerState sampler_of_mine;
float4 main(float4 v : POSITION) : SV_Position {
  // CHECK: [[#@LINE+1]]:14: error: the initialiser has too few components; `float4` has 4 [initialiser-count, X3037]
  float4 a = {1, 2, 3};
  // CHECK: [[#@LINE+1]]:16: error: the initialiser has too many components; `float[2]` has 2 [initialiser-count, X3037]
  float b[2] = {1, 2, 3};
  // CHECK: [[#@LINE+1]]:16: error: the initialiser has 3 components, not a whole number of `float2`, which has 2 [initialiser-not-whole, X3037]
  float2 c[] = {1, 2, 3};
  // CHECK: [[#@LINE+1]]:15: error: `SamplerState` is in an initialiser list; only numbers and types made of numbers can be [cannot-take-apart, X3037]
  float2 d = {sampler_of_mine, 1};
  return v;
}
