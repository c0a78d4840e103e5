// A float that does not fit into the integer saturates, and NaN becomes 0: Direct3D 11.3 Functional Specification, ftoi and ftou.
// GLSL leaves both undefined. pow(0, y) is exp2(y * log2(0)), which the table of precisions in GLSL 4.60, 4.7.1, says of
// pow: infinity for a y below 0.
// RUN: %draw compare %s -T vs_5_0 --target=glsl450,glsl330,essl300,vulkan
// RUN: %draw compare %s -T vs_5_0 --target=essl310
// RUN: %clipc -T vs_6_0 %s -o - | FileCheck %s --check-prefix=DXIL
// DXIL-NOT: to_{{u?}}int
float4 bones[12];
// Constants get the value itself, since GLSL has no calls there.
// RUN: %clipc -T vs_5_0 %s --validate -o - | FileCheck %s --check-prefix=CONST
// CONST: const int beyond[1] = int[1](ivec2(2147483647, int(0x80000000u)).x ^ 1);
static const float2 far_away[1] = {float2(2, -4)};
static const int beyond[1] = {((int2)(far_away[0] * 1073741824.0)).x ^ 1};

struct Output {
  float4 position : SV_Position;
  nointerpolation int4 ints : INTS;
  nointerpolation uint4 uints : UINTS;
  nointerpolation min16int2 small : SMALL;
  nointerpolation int one : ONE;
  nointerpolation uint2 halves : HALVES;
  float4 skinned : SKINNED;
  float4 power : POWER;
};

float4 Skin(int4 i) { return bones[i.x] + bones[i.y * 2 + 1]; }

Output main(float4 p : POSITION, uint4 n : NUMBERS) {
  Output o;
  o.position = p;
  o.ints = int4(p * 1e9);
  o.uints = uint4(p * 2e9);
  o.ints.x += int(asfloat(0x7fc00000u + (n.x & 7)));  // NaN
  o.uints.x += uint(asfloat(0xffc00000u + (n.y & 7))) + uint(asfloat(0x7f800000u + (n.x & 0)));
  o.uints.y += uint2(saturate(p.xy) * 255.0 + 0.5).y;
  o.halves = uint2((half2)p.zw * 2000000000) + uint((half)-p.x * 2e9);
  o.small = min16int2(half2(p.xy));
  o.ints.y ^= beyond[n.x & 0];
  o.one = ((int1)(p.x * 1e10)).x + int(min(max(p.x, -5), 7.0));
  o.skinned = Skin(int4(saturate(p) * 3)) + bones[uint(abs(p.y) * 0 - 1)];
  o.skinned += bones[(int)(p.x * 1e10) & 3] + bones[(uint)(abs(p.y) * 1e10) >> 30];
  o.power = pow(p.x * 0, float4(-1, -0.5, 0.5, 2));
  return o;
}
