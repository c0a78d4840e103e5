// A decimal literal without a suffix is an int up to shader model 5.1, and wraps; DXC takes its value (vkd3d's test of numeric
// initial values, checked against native).
// RUN: %clipc -T vs_5_1 %s --validate | FileCheck %s --check-prefixes=CHECK,FXC
// RUN: %clipc -T vs_6_0 %s --validate | FileCheck %s --check-prefixes=CHECK,DXC
float4 main() : SV_Position {
  // FXC: float x = -1294967296.0;
  // DXC: float x = 3e+09;
  float x = 3000000000;
  // FXC: int half_of = -1294967296 / 2;
  // DXC: int half_of = 1500000000;
  int half_of = 3000000000 / 2;
  // CHECK: uint every_bit = 4294967295u;
  uint every_bit = 4294967295;
  // CHECK: int least = int(0x80000000u);
  int least = -2147483648;
  return float4(x, half_of, every_bit, least);
}
