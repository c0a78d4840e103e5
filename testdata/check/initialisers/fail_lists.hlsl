// RUN: not %clipc -T vs_5_0 -E main %s 2>&1 | FileCheck %s
SamplerState sampler_of_mine;
float4 main(float4 v : POSITION) : SV_Position {
  // CHECK: [[#@LINE+1]]:14: error: too few components in the initialiser; `float4` has 4 [X3037]
  float4 a = {1, 2, 3};
  // CHECK: [[#@LINE+1]]:16: error: too many components in the initialiser; `float[2]` has 2 [X3037]
  float b[2] = {1, 2, 3};
  // CHECK: [[#@LINE+1]]:16: error: 3 components make no whole number of `float2`, which has 2 [X3037]
  float2 c[] = {1, 2, 3};
  // CHECK: [[#@LINE+1]]:15: error: `SamplerState` in an initialiser list; only numbers and what is made of them can stand there [X3037]
  float2 d = {sampler_of_mine, 1};
  return v;
}
