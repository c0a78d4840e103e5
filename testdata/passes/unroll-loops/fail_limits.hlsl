// Loops that are unrolled have limits, which the message names.
// RUN: not %clipc %s -T ps_4_0 -E iterations --target=webgl1 -o - 2>&1 | FileCheck %s --check-prefix=ITERATIONS
// RUN: not %clipc %s -T ps_4_0 -E expressions --target=essl100 -o - 2>&1 | FileCheck %s --check-prefix=EXPRESSIONS
// RUN: not %clipc %s -T ps_4_0 -E unknown --target=webgl1 -o - 2>&1 | FileCheck %s --check-prefix=UNKNOWN
// RUN: %clipc %s -T ps_4_0 -E stays --target=webgl1 --validate -o %t.frag
float4 iterations(float4 p : T) : SV_Target {
  int n = 2000;
  // ITERATIONS: [[#@LINE+1]]:3: error: this loop must be unrolled, and has more than 1024 iterations; target `webgl1` has only loops like `for (int i = 0; i < 8; ++i)` that may be longer [target-long-loop, X3511]
  while (n-- > 0) p *= 0.5;
  return p;
}
float4 expressions(float4 p : T) : SV_Target {
  int n = 1000, sum = 0;
  // EXPRESSIONS: error: this loop must be unrolled, and has more than 65536 expressions; target `essl100` has only
  while (n-- > 0) {
    int m = 1000;
    while (m-- > 0) p = p * p.x + p.yxwz * p.w;
  }
  return p;
}
float4 unknown(float4 p : T) : SV_Target {
  int n = p.x;
  // UNKNOWN: [[#@LINE+1]]:3: error: this loop is a `while`, and its iterations are not known; target `webgl1` has only loops like `for (int i = 0; i < 8; ++i)`, from constant to constant (GLSL ES 1.00, appendix A), and those that can be unrolled [target-loop]
  while (n-- > 0) p *= 0.5;
  return p;
}
float4 stays(float4 p : T) : SV_Target {
  for (int i = 0; i < 2000; i++) p *= 0.5;
  return p;
}
