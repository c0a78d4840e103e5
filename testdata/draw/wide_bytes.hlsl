// Values of 64 bits in a buffer of bytes, the low word first: vkd3d's uav-rwbyteaddressbuffer.shader_test, line 90, checked against dxc.
// RUN: %draw compare %s -T vs_6_0 --target glsl450
RWByteAddressBuffer b : register(u1);
struct Padded { float a; double b; float c; };
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
  // A struct is padded as its widest number asks (DXC's method.byte-address-buffer.templated-load.struct): 24 bytes here.
  Padded padded[2] = {{p.y, 2.25, p.z}, {p.w, -6.5, p.x}};
  b.Store(88, padded);
  padded = b.Load<Padded[2]>(88);
  const float lies = b.Load<float>(88) + b.Load<double>(96) + b.Load<float>(104) + b.Load<float>(112) + b.Load<double>(120);
  const int64_t whole = b.Load<int64_t>(0);
  return float4(whole / 1000000000, b.Load<double>(8), read.d.x + read.d.y, read.i + read.u) + b.Load<double>(16) +
         float4(padded[0].a, padded[0].b + padded[1].b, padded[1].a - padded[0].c, lies + padded[1].c);
}
