// A function that only the first value of a static variable calls, constants that may be specialised, matrices of integers.
// RUN: %clipc -T vs_6_0 -spirv -S %s -o - | FileCheck %s
// RUN: %clipc -T vs_6_0 -spirv %s -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %draw compare %s -T vs_6_0 --target vulkan
float4 light;
row_major int2x4 numbers;
float Twice(float x) { return x + x; }
static float strength = Twice(light.x);
static const float table[4] = {1, 2, 4, 8};
// CHECK: OpDecorate %levels SpecId 7
// CHECK: %levels = OpSpecConstant %int 3
[[vk::constant_id(7)]] const int levels = 3;
float4 main(float4 p : POSITION, uint2 place : PLACE) : SV_Position {
  int2x4 sums = numbers + numbers * 2;
  float3x2 turn = {p.x, p.y, p.z, p.w, 1, 2};
  sums[1].y += levels;
  turn[place.x & 1] *= strength;
  return float4(mul(p.xyz, turn), sums[place.y & 1].yx) * table[place.x & 3];
}
