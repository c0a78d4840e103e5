// An element that no literal names is of no array under -fspv-flatten-resource-arrays.
// RUN: not %clipc -T ps_6_0 %s --target=vulkan -fspv-flatten-resource-arrays -o - 2>&1 | FileCheck %s
// RUN: not %clipc -T ps_6_0 -E taken %s --target=vulkan -fspv-flatten-resource-arrays -o - 2>&1 | FileCheck %s --check-prefix=TAKEN
// RUN: not %clipc -T ps_6_0 -E moved %s --target=vulkan --bindings=dxc -fspv-flatten-resource-arrays -o - 2>&1 | FileCheck %s --check-prefix=MOVED
Texture2D maps[3] : register(t1);
SamplerState smooth : register(s0);
float4 main(float2 uv : UV, nointerpolation uint i : INDEX) : SV_Target {
  // CHECK: [[#@LINE+1]]:10: error: the index of `maps` is not constant, and `-fspv-flatten-resource-arrays` makes a resource of its own of each element; index by constants, or leave out the option [target-split-index]
  return maps[i].Sample(smooth, uv);
}
Texture2D loose[2];
// The sampler has binding 0 there. MOVED: error: `-fspv-flatten-resource-arrays` of `loose`, an array without a register whose binding is taken, is not supported [unsupported]
float4 moved(float2 uv : UV) : SV_Target { return loose[1].Sample(smooth, uv); }
[[vk::binding(291)]] Texture2D third;
// TAKEN: error: `maps` and `third` both become binding 291 of set 0
float4 taken(float2 uv : UV) : SV_Target { return maps[0].Sample(smooth, uv) + third.Sample(smooth, uv); }
