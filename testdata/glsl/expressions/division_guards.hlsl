// A division by what cannot be 0 has no guard.
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s --implicit-check-not=divide --implicit-check-not=modulo
// RUN: %clipc -T vs_5_0 -DGUARDED --validate %s -o - | FileCheck %s --check-prefix=GUARD
// GUARD: uint divide(uint x, uint y) {
// GUARD-NEXT: return y == 0u ? ~0u : x / y;
// GUARD: int modulo(int x, int y) {
int count;
static const int kThree = 3;
float4 main(uint2 m : M, int2 n : N) : SV_Position {
  uint4 r;
  const uint k = 7;
  uint one_value = max(m.x, 2u);
  // CHECK: in_M0.x / 4u
  r.x = m.x / 4 + m.x % k + m.y / (m.x | 1) + m.y % max(m.x, 1u);
  r.y = m.x / one_value + m.x % (1u << m.y);
  r.z = n.x / kThree + n.y % clamp(n.x, 1, 8) + n.x / (n.y > 2 ? 5 : -7);
  r.w = m.x / (count > 0 ? 3u : 2u);
  uint2 v = m / uint2(2, 3), w = m;
  w /= 2;
  w %= uint2(m.x | 2u, 9);
  r.xy += v + w;
#ifdef GUARDED
  r.x += m.x / m.y + n.x % n.y;
#endif
  return r;
}
