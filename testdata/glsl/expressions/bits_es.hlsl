// In GLSL ES findMSB and its kin give a lowp int, of which Mesa keeps 16 bits: converted to uint, -1 would be 65535.
// RUN: %clipc -T vs_5_0 --target=essl310 --validate %s -o - | FileCheck %s
// RUN: %draw compare %s -T vs_5_0 --target=essl310,glsl450
// CHECK: uvec4 first_bit_high(ivec4 x) {
// CHECK-NEXT:     ivec4 bit = findMSB(x);
// CHECK-NEXT:     return uvec4(bit);
struct Output {
  float4 position : SV_Position;
  nointerpolation uint4 high : HIGH;
  nointerpolation uint4 low : LOW;
  nointerpolation uint4 count : COUNT;
};
Output main(float4 p : POSITION, int4 i : INTS, uint4 u : UINTS) {
  Output o;
  o.position = p;
  o.high = firstbithigh(i) + firstbithigh(u & 1);
  o.low = firstbitlow(u & 2) + firstbitlow(0u);
  o.count = countbits(i) * 100000u;
  return o;
}
