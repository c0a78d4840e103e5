// From 6.0 on a literal without a suffix has 64 bits until it becomes what is beside it: an int or a uint has the lower 32, as CombineBasicTypes
// of DXC's SemaHLSL.cpp has it, with the warning of Clang's -Wconstant-conversion; a double has all digits (constant.scalar.64bit.hlsl of
// its CodeGenSPIRV), and infinity is named where a float stays one.
// RUN: %clipc -T vs_6_0 --dump-after=resolve-objects %s 2> %t | FileCheck %s
// RUN: FileCheck %s --check-prefix=WARN --implicit-check-not=warning: < %t
// RUN: %clipc -T vs_6_0 --validate %s -Wno-literal-truncated -Wno-float-literal-range -Wno-implicit-narrowing -o %t.vert
cbuffer C { int i; uint u; bool b; double d; int64_t l; float f; };
// CHECK: double far = 1e+300L
static double far = 1e300;
void Use(double x) {}
float4 main() : SV_Position {
  // CHECK: int product = i * 705032704
  // WARN: [[#@LINE+1]]:21: warning: 5000000000 does not fit into `int` and becomes 705032704; the suffix `ll` makes a number of 64 bits [-Wliteral-truncated]
  int product = i * 5000000000;
  // CHECK-NEXT: bool less = u < 4294967295u
  // WARN: [[#@LINE+1]]:19: warning: 68719476735 does not fit into `uint` and becomes 4294967295; {{.*}} [-Wliteral-truncated]
  bool less = u < 0xfffffffff;
  // CHECK-NEXT: int alone = -1
  // WARN: [[#@LINE+1]]:15: warning: 68719476735 does not fit into `int` and becomes -1; {{.*}} [-Wliteral-truncated]
  int alone = 0xfffffffff;
  // CHECK-NEXT: uint typed = 705032704u
  // WARN: [[#@LINE+1]]:16: warning: 5000000000 does not fit into `uint` and becomes 705032704; {{.*}} [-Wliteral-truncated]
  uint typed = 5000000000u;
  // CHECK-NEXT: int most = max(i, 705032704)
  // WARN: [[#@LINE+1]]:21: warning: 5000000000 does not fit into `int` and becomes 705032704; {{.*}} [-Wliteral-truncated]
  int most = max(i, 5000000000);
  // CHECK-NEXT: int truth = convert<int>(b) + -1294967296
  int truth = b + 3000000000;
  // CHECK-NEXT: bool both = b && true
  bool both = b && 4294967296;
  // CHECK-NEXT: float number = f * 5e+09
  float number = f * 5000000000;
  // CHECK-NEXT: int64_t wide = l * 5000000000LL
  int64_t wide = l * 5000000000;
  // CHECK-NEXT: int64_t suffixed = convert<int64_t>(i) * 5000000000LL
  int64_t suffixed = i * 5000000000ll;
  // CHECK-NEXT: uint cast = 3000000000u + convert<uint>(i)
  uint cast = (uint)3000000000 + i;
  // What is made of literals has 64 bits too, in whatever radix; ints have the lower 32 as they are.
  // CHECK-NEXT: float power = 4294967296.0
  float power = 65536 * 65536;
  // CHECK-NEXT: float high = f * 2147483648.0
  float high = f * (1 << 31);
  // CHECK-NEXT: int64_t shifted = 1099511627776LL
  int64_t shifted = 1 << 40;
  // CHECK-NEXT: int64_t low = 65536LL
  int64_t low = 65536 * 65536 >> 16;
  // CHECK-NEXT: uint masked = u & (~4278190080u)
  uint masked = u & ~0xff000000;
  // CHECK-NEXT: int set = i | (1 << 31)
  int set = i | 1 << 31;
  // CHECK-NEXT: bool ordered = true
  bool ordered = -1 < 0xffffffff;
  // CHECK-NEXT: uint none = 0u
  // WARN: [[#@LINE+1]]:15: warning: 4294967296 does not fit into `uint` and becomes 0; {{.*}} [-Wliteral-truncated]
  uint none = 65536 * 65536;
  // CHECK-NEXT: double third = d * 0.333{{3+}}L
  double third = d * (1.0 / 3.0);
  // CHECK-NEXT: double fifth = d * 0.2L
  double fifth = d * (2 * 0.1);
  // CHECK-NEXT: double rounded = (d * 0.10000000149011612L) + (d * 0.10000000149011612L)
  double rounded = d * (float)0.1 + d * float(0.1);
  // CHECK-NEXT: double2 pair = double2(0.1L, 0.1L)
  double2 pair = double2(0.1, (double)0.1);
  // CHECK-NEXT: double bound = clamp(d, -1e+300L, 1e+300L)
  double bound = clamp(d, -1e300, 1e300);
  // WARN: [[#@LINE+1]]:19: warning: `1e+300` is too large for its type and becomes infinity [-Wfloat-literal-range]
  float endless = 1e300;
  // CHECK: switch (i)
  // CHECK-NEXT: case 705032704:
  // CHECK: case -2147483648:
  // WARN: [[#@LINE+1]]:21: warning: 5000000000 does not fit into `int` and becomes 705032704; {{.*}} [-Wliteral-truncated]
  switch (i) { case 5000000000: alone = 2; break; case 1 << 31: alone = 3; }
  Use(1e300);
  return float4(product + less + alone, typed + most + truth + both + number + endless + power + high + set + ordered, (float)(wide + suffixed + shifted + low + masked + none) + cast, (float)(third + fifth + rounded + pair.x + bound + far));
}
