// A message about a value that is not written names the variable of the text, not one that clipc makes for the value.
// RUN: %clipc -T cs_6_0 -fsyntax-only %s 2>&1 | FileCheck %s --implicit-check-not=warning:
RWStructuredBuffer<uint> o;
[numthreads(1, 1, 1)] void main() {
  // CHECK: [[#@LINE+2]]:23: warning: `a` is read before anything is written to it; its value is undefined [-Wvariable-not-written]
  uint64_t a;
  o[0] = firstbithigh(a);
  // CHECK: [[#@LINE-2]]:12: note: `a` is declared here
}
