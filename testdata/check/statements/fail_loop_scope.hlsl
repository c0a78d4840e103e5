// The variable of a loop's head ends with the loop from HLSL 2021 on, as in C++; before, and in fxc, it is visible after it (X3078).
// RUN: not %clipc -T vs_6_0 -fsyntax-only %s 2>&1 | FileCheck %s
// RUN: not %clipc -T vs_6_6 -HV 2021 -fsyntax-only %s 2>&1 | FileCheck %s
// RUN: %clipc -T vs_6_0 -HV 2018 %s -o %t
// RUN: %clipc -T vs_5_1 %s -o %t
// RUN: %clipc -T vs_5_1 -HV 2021 %s -o %t
float4 main(float4 p : P) : SV_Position {
  // CHECK: [[#@LINE+4]]:10: error: `i` is not declared [undeclared-name, X3004]
  // CHECK: [[#@LINE+1]]:12: note: `i` is the variable of this loop, and ends with it since HLSL 2021; declare it before the loop, or compile with `-HV 2018`
  for (int i = 0; i < 3; i++) p *= 2;
  for (int j = 0, k = 1; j < 3; j++) p += k;
  return i + p;
}
