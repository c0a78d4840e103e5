// RUN: not %clipc -T vs_5_0 -E main %s 2>&1 | FileCheck %s
float4 main(float4 v : POSITION, int n : N) : SV_Position {
  // CHECK: [[#@LINE+1]]:3: error: `break` outside a loop or switch [break-outside-loop, X3518]
  break;
  // CHECK: [[#@LINE+1]]:3: error: `continue` outside a loop [continue-outside-loop, X3519]
  continue;
  // CHECK: [[#@LINE+1]]:3: error: a label outside the block of a switch [case-outside-switch, X3000]
  case 1:
  // CHECK: [[#@LINE+1]]:7: error: the condition of `if` is a `float4`; it must be a scalar [condition-not-scalar, X3019]
  if (v) n = 1;
  // CHECK: [[#@LINE+1]]:3: error: `discard` in a vertex shader; only pixels can be discarded [discard-in-vertex-shader, X4532]
  discard;
  switch (n) {
    // CHECK: [[#@LINE+1]]:5: error: a statement before the first `case` of a switch is never reached [statement-before-case, X3000]
    n = 2;
    case 1:
    // CHECK: [[#@LINE+1]]:5: error: `case 1` is given twice in one switch [case-twice, X3532]
    case 1: break;
    // CHECK: note: first given here
    // CHECK: [[#@LINE+1]]:10: error: `n` is not a constant integer; it must be known at compile time [not-constant-integer, X3058]
    case n: break;
  }
  // CHECK: [[#@LINE+1]]:15: error: `empty` is `const` and has no value; it needs one where it is declared [const-without-value, X3012]
  const float empty;
  // CHECK: [[#@LINE+1]]:11: error: the condition of `switch` is a `float4`; it must be a scalar [condition-not-scalar, X3019]
  switch (v) { default: break; }
  return v;
}
