// Operators inside shifts and bit operators have parentheses, as a reader wants them.
// RUN: %clipc -T vs_5_0 %s --validate -o - | FileCheck %s
// RUN: %draw compare %s -T vs_5_0
float4 main(float4 p : POSITION, uint4 v : V) : SV_Position {
  // CHECK: uint a = (in_V0.x << 1) & 2u;
  uint a = v.x << 1 & 2;
  // CHECK-NEXT: uint b = (in_V0.x & 255u) | (in_V0.y & 7u) | in_V0.z;
  uint b = v.x & 255 | v.y & 7 | v.z;
  // CHECK-NEXT: uint c = (in_V0.x + 1u) << 2;
  uint c = v.x + 1 << 2;
  // CHECK-NEXT: uint d = (in_V0.x ^ (in_V0.y >> 3)) & ~in_V0.z;
  uint d = (v.x ^ v.y >> 3) & ~v.z;
  // CHECK-NEXT: uvec4 e = (in_V0 << (uvec4(1u, 2u, 3u, 4u) & 31u)) & 2u;
  uint4 e = v << uint4(1, 2, 3, 4) & 2;
  return p + a + b + c + d + e;
}
