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

// CHECK: program vs_5_0 form inlined
// CHECK-NEXT: input float4 in_POSITION0 : POSITION0 location 0
// CHECK-NEXT: input int2 in_COUNT0 : COUNT0 location 1
// CHECK-NEXT: input uint2 in_BITS0 : BITS0 location 2
// CHECK-NEXT: output float4 vs_SV_POSITION0 : SV_Position0 builtin position
// CHECK-NEXT: entry void main() {
// CHECK-NEXT: }
// CHECK-NEXT: main void main.1() {
// CHECK-NEXT:   int shifted = in_COUNT0.x << (in_COUNT0.y & 31)
// CHECK-NEXT:   shifted >>= 1
// CHECK-NEXT:   uint rest = modulo(in_BITS0.x, in_BITS0.y)
// CHECK-NEXT:   int remainder = modulo.1(in_COUNT0.x, in_COUNT0.y)
// CHECK-NEXT:   vs_SV_POSITION0 = ((((((in_POSITION0 * (splat<float4>(1.0) / in_POSITION0)) + (in_POSITION0 * exp2(splat<float4>(2.0)))) + fmod(in_POSITION0, splat<float4>(3.0))) + fmod(in_POSITION0, splat<float4>(4.0))) + splat<float4>(convert<float>(shifted))) + splat<float4>(convert<float>(rest))) + splat<float4>(convert<float>(remainder))
// CHECK-NEXT: }
// CHECK-NEXT: helper uint modulo(uint x, uint y) {
// CHECK-NEXT:   return (y == 0u) ? (~0u) : (x % y)
// CHECK-NEXT: }
// CHECK-NEXT: helper int modulo.1(int x.1, int y.1) {
// CHECK-NEXT:   return (y.1 == 0) ? ((x.1 < 0) ? 1 : -1) : imod(x.1, (y.1 == -1) ? 1 : y.1)
// CHECK-NEXT: }
// CHECK-NEXT: helper float4 fmod(float4 x.2, float4 y.2) {
// CHECK-NEXT:   return x.2 - (y.2 * trunc(x.2 / y.2))
// CHECK-NEXT: }
// CHECK-NEXT: helper int imod(int x.3, int y.3) {
// CHECK-NEXT:   return x.3 - (y.3 * (x.3 / y.3))
// CHECK-NEXT: }
