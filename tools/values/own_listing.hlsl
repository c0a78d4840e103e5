// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The self test of run_listings.py: own_listing.asm is this shader, written by hand in the words of fxc's listings.
Texture2D map;
SamplerState smooth;
float4 tint;
int count;

float4 main(float4 place : SV_Position, float3 color : COLOR0, nointerpolation uint2 pick : PICK0) : SV_Target {
  float4 sum = tint;
  for (int i = 0; i < 3; ++i) sum += map.SampleLevel(smooth, color.yx * i, 0);
  if (color.z < 0.25) sum.x = frac(color.x) + ddy(color.y);
  sum.w = (pick.x & 3) == 1 ? place.x : sum.w * count;
  return saturate(sum);
}
