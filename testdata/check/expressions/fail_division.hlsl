// An integer divided by 0 is an error. Oracles: Microsoft's page of HLSL's errors, X4009 and X4010; dxc's validator, "No signed
// integer division by zero". What control does not reach is not a division.
// RUN: not %clipc -T vs_5_0 -fsyntax-only %s 2>&1 | FileCheck %s --implicit-check-not=error:
// RUN: not %clipc -T vs_6_0 -fsyntax-only %s 2>&1 | FileCheck %s --implicit-check-not=error:
#define COUNT 0
static const int none = 0;
float4 main(float4 p : POSITION, int n : N, uint u : U) : SV_Position {
  // CHECK: [[#@LINE+1]]:15: error: an integer is divided by 0; the result is undefined [integer-division-by-zero, X4009]
  int a = n / COUNT;
  // CHECK: [[#@LINE+1]]:16: error: an integer is divided by 0
  uint b = u % 0u;
  // CHECK: [[#@LINE+1]]:8: error: an integer is divided by 0
  n /= none;
  int d = COUNT == 0 ? 0 : n / COUNT;
  if (COUNT > 0) d += n / COUNT;
  return p * (a + b + d);
}
