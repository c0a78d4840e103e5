// dxc reads C++14's binary numbers; fxc has none.
// RUN: not %clipc -T vs_5_1 -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=OLD
// RUN: %clipc -T vs_6_0 --validate %s -o - | FileCheck %s
#if 0b11 != 3
#error
#endif
// CHECK: const uint kMask = 5u;
// OLD: [[#@LINE+1]]:27: error: `0b101u` is not a number; binary numbers begin with shader model 6.0 [invalid-number, X3000]
static const uint kMask = 0b101u;
float4 main(uint n : N) : SV_Position {
  // CHECK: & kMask) | 255u
  return (n & kMask) | 0B11111111;
}
