// fxc reads 3000000000 as the int -1294967296, and a sum of literals below the range of an int is the least one; dxc counts with more
// bits. Oracle: vkd3d's sm1-const-folding.shader_test, lines 91 to 134, checked against fxc.
// RUN: %clipc -T ps_5_0 %s -o - | FileCheck %s
// RUN: %draw compare %s -T ps_5_0
static int n = -1294967296;
float4 main() : SV_Target {
  // CHECK: int a = {{.*}}0x80000000
  int a = 3000000000 + 3000000000;
  // CHECK-NEXT: uint b = 2147483648u;
  uint b = 3000000000 * 2;
  // CHECK-NEXT: uint c = 3000000000u + 3000000000u;
  uint c = 3000000000u + 3000000000u;
  // CHECK-NEXT: int d = n + -1294967296;
  int d = n + 3000000000;
  return float4(a, b, c, d);
}
