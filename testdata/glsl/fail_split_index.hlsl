// An element that no literal names is of no array under -fspv-flatten-resource-arrays.
// RUN: not %clipc -T ps_6_0 %s --target=vulkan -fspv-flatten-resource-arrays -o - 2>&1 | FileCheck %s
Texture2D maps[3] : register(t1);
SamplerState smooth : register(s0);
float4 main(float2 uv : UV, nointerpolation uint i : INDEX) : SV_Target {
  // CHECK: [[#@LINE+1]]:10: error: the index of `maps` is not constant, and `-fspv-flatten-resource-arrays` makes a resource of its own of each element; index by constants, or leave out the option [target-split-index]
  return maps[i].Sample(smooth, uv);
}
