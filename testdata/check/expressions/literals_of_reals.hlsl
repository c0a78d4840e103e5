// From 6.0 on operators and conversions of literals with a point and without a suffix are those of 64 bits: LitFloatTy in DXC's
// SemaExpr.cpp. What floats would compute otherwise is a literal of its own; the rest stays as it is written.
// RUN: %clipc -T vs_6_0 --dump-after=resolve-objects %s | FileCheck %s
// RUN: %clipc -T vs_5_1 --dump-after=resolve-objects %s | FileCheck %s --check-prefix=OLD
cbuffer C { double d; };
float4 main() : SV_Position {
  // CHECK: float huge = 1e+20
  float huge = 1e30 * 1e30 / 1e40;
  // CHECK-NEXT: float tiny = 1e-20
  float tiny = 1e-30 * 1e-30 * 1e40;
  // CHECK-NEXT: float negative = -1.0
  float negative = -1e39 / 1e39;
  // CHECK-NEXT: float difference = 1.0
  // OLD: float difference = 2147483648.0 - 2147483648.0
  float difference = 2147483647.0 - 2147483646.0;
  // CHECK-NEXT: float third = 1.0 / 3.0
  float third = 1.0 / 3.0;
  // CHECK-NEXT: bool equal = false
  // OLD: bool equal = (0.1 + 0.2) == 0.3
  bool equal = 0.1 + 0.2 == 0.3;
  // CHECK-NEXT: bool above = 2.0 > 1.0
  bool above = 2.0 > 1.0;
  // CHECK-NEXT: int odd = 16777217
  // OLD: int odd = 16777216
  int odd = 16777217.0;
  // CHECK-NEXT: int sum = 16777217
  int sum = 16777216.0 + 1;
  // CHECK-NEXT: uint large = 3000000001u
  uint large = 3000000001.0;
  // CHECK-NEXT: int3 splat = splat<int3>(16777217)
  int3 splat = 16777217.0;
  // CHECK-NEXT: double product = d * 1.2000000000000002L
  double product = d * (1.1 * 1.1 - 0.01);
  // CHECK-NEXT: int typed = 16777216
  int typed = (float)16777217.0;
  return huge + tiny + negative + difference + third + equal + above + odd + sum + large + splat.x + float(product) + typed;
}
