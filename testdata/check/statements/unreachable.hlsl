// A statement after a jump of its block is a warning, once for each jump; what follows a label, and an empty statement, is none. No
// oracle: neither fxc nor dxc says it by default; what is taken without effect is said.
// RUN: %clipc -T vs_5_0 -fsyntax-only %s 2>&1 | FileCheck %s --implicit-check-not=warning:
// RUN: %clipc -T vs_5_0 -fsyntax-only -Wno-unreachable-code %s 2>&1 | count 0
float4 Early(float4 x) {
  return x;;
}
float4 main(float4 p : POSITION, int n : NUMBER) : SV_Position {
  for (int i = 0; i < 4; ++i) {
    if (p.x > i) {
      continue;
      // CHECK: [[#@LINE+1]]:7: warning: this is never reached; a `continue` is before it [-Wunreachable-code]
      p *= 2;
      p *= 3;
    }
    if (p.y > i) {
      break;
      // CHECK: [[#@LINE+1]]:7: warning: this is never reached; a `break` is before it
      p *= 4;
    }
  }
  switch (n) {
    case 0: return p;
    case 1: return p * 2; break;
    default: break;
  }
  return Early(p);
  // CHECK: [[#@LINE+1]]:3: warning: this is never reached; a `return` is before it
  return p;
}
