// The cases of a switch. Oracles: fxc X3533 and X3708, Microsoft's page of HLSL's errors; vkd3d's switch.shader_test, checked against
// native: unterminated cases and `continue` fail before 6.0, a float value before 4.0 and from 6.0 on, a last label without a
// statement in all.
// RUN: split-file %s %t
// RUN: not %clipc -T vs_5_0 -fsyntax-only %t/cases.hlsl 2>&1 | FileCheck %t/cases.hlsl
// RUN: %clipc -T vs_6_0 -fsyntax-only %t/cases.hlsl 2>&1 | count 0
// RUN: not %clipc -T vs_6_0 -fsyntax-only %t/label.hlsl 2>&1 | FileCheck %t/label.hlsl
// RUN: %clipc -T vs_5_0 -fsyntax-only %t/float.hlsl 2>&1 | count 0
// RUN: not %clipc -T vs_6_0 -fsyntax-only %t/float.hlsl 2>&1 | FileCheck %t/float.hlsl
// RUN: not %clipc -T vs_3_0 -fsyntax-only -Gec %t/float.hlsl 2>&1 | FileCheck %t/float.hlsl
//--- cases.hlsl
float4 main(float4 p : POSITION, int n : N) : SV_Position {
  switch (n) {
    // CHECK: [[#@LINE+1]]:5: error: a case with statements does not end with `break` or `return`; up to shader model 5.1 it must [case-without-break, X3533]
    case 0: p += 1;
    case 1: p += 2; break;
    case 2:
    case 3: {
      p += 3;
      break;
    }
    case 4: if (p.x > 0) return p; else break;
    // Known conditions decide, as in fxc.
    case 5:
      if (true) break;
      p = 9;
    case 6:
      if (false) break;
      p += 4;
      break;
    case 7: while (true) { if (p.x > 3) return p; p += 1; }
    // CHECK: [[#@LINE+1]]:5: error: a case with statements does not end
    case 8:
      switch (n + 1) { case 9: break; default: return p; }
    // CHECK: [[#@LINE+1]]:5: error: a case with statements does not end
    default: p += 5;
  }
  for (int i = 0; i < n; ++i) {
    switch (i) {
      case 1:
        // CHECK: [[#@LINE+1]]:9: error: `continue` is in a switch; up to shader model 5.1 only a loop may contain it [continue-in-switch, X3708]
        continue;
      case 2:
        for (int j = 0; j < n; ++j) {
          if (j == i) continue;
          p += 1;
        }
        break;
    }
  }
  return p;
}
//--- label.hlsl
float4 main(float4 p : POSITION, int n : N) : SV_Position {
  switch (n) {
    case 0: ;
  }
  switch (n) {
    case 0: break;
    // CHECK: [[#@LINE+1]]:5: error: the last label of a switch has no statement; `break;` is one [case-without-statement, X3000]
    default:
  }
  return p;
}
//--- float.hlsl
float4 main(float4 p : POSITION, float4 n : N) : SV_Position {
  // CHECK: [[#@LINE+1]]:11: error: the value of `switch` is a `float`; it must be an integer [switch-not-integer]
  switch (n.x) { case 0: p += 1; break; }
  return p;
}
