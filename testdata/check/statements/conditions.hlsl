// An assignment as a condition, from 6.0 on. Oracle: dxc's -Wparentheses, "using the result of an assignment as a condition without
// parentheses"; fxc has no word about it.
// RUN: %clipc -T vs_6_0 -fsyntax-only %s 2>&1 | FileCheck %s --implicit-check-not=warning:
// RUN: %clipc -T vs_6_0 -fsyntax-only -Wno-assignment-as-condition %s 2>&1 | count 0
// RUN: %clipc -T vs_5_0 -fsyntax-only %s 2>&1 | count 0
float4 main(float4 p : POSITION, int n : N) : SV_Position {
  int m = n;
  // CHECK: [[#@LINE+1]]:7: warning: the condition of `if` is an assignment; `==` compares, and a second pair of parentheses says that the assignment is meant [-Wassignment-as-condition]
  if (m = 3) p += 1;
  if ((m = n)) p += 2;
  if (m == n) p += 3;
  // CHECK: [[#@LINE+1]]:10: warning: the condition of `while` is an assignment
  while (m = m - 1) p += 4;
  return p;
}
