// Functions that are short for others are spelled out, counts of shifts are taken modulo 32, and % is fmod.
// RUN: %clipc -T vs_5_0 --verify --dump-after=lower-arithmetic --stop-after=lower-arithmetic %s | FileCheck %s
// RUN: %draw compare %s -T vs_5_0
// AUTOUPDATE
float4 main(float4 p : POSITION, int2 n : COUNT, uint2 u : BITS) : SV_Position {
  int shifted = n.x << n.y;
  shifted >>= 33;
  uint rest = u.x % u.y;
  int remainder = n.x % n.y;
  return mad(p, rcp(p), ldexp(p, 2)) + p % 3 + fmod(p, 4) + shifted + rest + remainder;
}
