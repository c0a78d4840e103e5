// An integer divided by 0. Direct3D's udiv gives 0xffffffff for the quotient and the remainder ("udiv (sm4 - asm)"); fxc divides the
// magnitudes of signed numbers by it, and sets the sign.
// RUN: %draw compare %s -T vs_5_0 --target=glsl450,glsl330,essl300,vulkan
// RUN: %draw compare %s -T vs_6_0 --target=glsl130,essl310,vulkan
int4 u;
struct Out {
  float4 p : SV_Position;
  uint4 a : A;
  int4 b : B;
  uint4 c : C;
  int4 d : D;
};
Out main(int4 n : N, uint2 m : M) {
  Out o;
  o.p = 0;
  // Inputs are small, so that many divisors are 0 and -1.
  int4 s = clamp(n, -2, 2);
  uint2 z = m & 1;
  o.a = uint4(m.x / z.x, m.x % z.x, uint2(7, m.y) / z);
  o.b = int4(n.x / s.x, n.x % s.x, n.zw / s.yz);
  o.c.xy = uint2(9, m.y) % z;
  o.c.zw = m;
  o.c.zw /= z;
  o.c.z += (m.x %= z.y);
  o.c.w /= z.x;
  o.d = n;
  o.d %= s;
  uint table[2] = {5, 6};
  int i = 0;
  table[i++] /= z.x;
  o.d.x += table[0] + i;
  const int least = -2147483647 - 1;
  o.d.w ^= least / s.w;
  int2x2 q = int2x2(n) / int2x2(s), r = int2x2(n);
  r %= int2x2(s);
  o.d += int4(q[0], r[1]);
  return o;
}
