// countbits, firstbithigh and firstbitlow of 64 bits: vkd3d's bitwise.shader_test, line 329, checked against dxc.
// RUN: %draw compare %s -T vs_6_0 --target glsl450
// RUN: %clipc %s -T vs_6_0 --target=glsl450 --validate -o %t
float4 main(int2 n : N, out uint4 single : U, out uint4 both : B, out uint4 edges : E) : SV_Position {
  const int64_t i = int64_t(n.x) * 9000000000 + n.y;
  const uint64_t u = (uint64_t)i;
  single = uint4(countbits(u), firstbitlow(u), firstbithigh(u), firstbithigh(i));
  const uint64_t2 pair = uint64_t2(u, u >> 40);
  both = uint4(firstbithigh(pair), firstbitlow(pair << 35));
  const uint64_t zero = (uint64_t)(n.x - n.x);
  edges = uint4(firstbitlow(zero), firstbithigh(zero), firstbithigh((int64_t)~zero), countbits(~zero));
  return 0;
}
