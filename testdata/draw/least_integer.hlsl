// The least integer by -1 has a result, and does not end Mesa's compiler, also where an operator makes it.
// RUN: %draw compare %s -T vs_5_0
// RUN: %draw compare %s -T vs_6_0
static const int kLeast = 1 << 31;
int4 main(int2 n : N, out float4 p : SV_Position) : R {
  p = 0;
  const int a = (1 << 31) / -1;
  const int b = (-2147483647 - 1) % -1;
  const int c = kLeast / (n.x - n.x - 1);
  const int d = ~0x7fffffff / n.y;
  return int4(a == kLeast, b, c == kLeast, n.y == 0 ? 0 : d);
}
