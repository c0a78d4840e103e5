// Integers match to the bit.
// RUN: %draw compare %s -T vs_5_0 -E main --target glsl450,glsl330,glsl130,essl300,vulkan --exact --lower none
// RUN: %draw compare %s -T vs_5_0 -E main --target glsl450,essl310 --exact --lower none --ints -2000000000..2000000000 --seed 2

int4 i;
uint4 u;
bool2 flags;

struct Output {
  float4 position : SV_Position;
  int4 a : A;
  uint4 b : B;
  int4 c : C;
  uint4 d : D;
};

Output main(int4 p : POSITION, uint4 q : BLENDINDICES) {
  Output result;
  result.position = float4(p);
  result.a = p * i + (p - 7) - ~p;
  result.b = (q << (u & 7)) ^ (q >> u) | (u & 12u);
  result.c = (p >> 3) + (p << 35) + int4(p.x > i.x, p.y <= i.y, p.z == i.z, p.w != i.w);
  result.d = uint4(q.x / (u.x | 1), q.y % (u.y | 1), (uint)p.x, flags.x ? 5u : q.w);
  result.c.x += p.x / (abs(i.x) | 1) + p.y % (abs(i.y) | 1);
  result.c.y += -7 / (abs(i.z) % 5 + 1) + -7 % (abs(i.w) % 5 + 1);
  result.c.z = min(p.z, i.z) + max(p.x, i.y) * sign(p.y);
  result.c.w = (flags.y && p.x < 3) || p.y > 1;
  return result;
}
