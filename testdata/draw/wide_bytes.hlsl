// Values of 64 bits in a buffer of bytes, the low word first: vkd3d's uav-rwbyteaddressbuffer.shader_test, line 90, checked against dxc.
// RUN: %draw compare %s -T vs_6_0 --target glsl450
RWByteAddressBuffer b : register(u1);
struct Pair { double2 d; int64_t i; uint u; };
float4 main(float4 p : P, int2 n : N) : SV_Position {
  b.Store<int64_t>(0, int64_t(n.x) * 5000000000);
  b.Store<double>(8, 13.25 * n.y);
  b.Store(16, (double)p.x);
  b.Store(24, uint64_t2(uint2(n)) << 33);
  Pair pair;
  pair.d = double2(p.x, 0.5);
  pair.i = -12;
  pair.u = 7;
  b.Store(48, pair);
  const Pair read = b.Load<Pair>(48);
  const int64_t whole = b.Load<int64_t>(0);
  return float4(whole / 1000000000, b.Load<double>(8), read.d.x + read.d.y, read.i + read.u) + b.Load<double>(16);
}
