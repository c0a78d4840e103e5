// Loops that never end. Oracles: fxc X3696, "infinite loop detected - loop never exits", in the listings of Tint's tests; dxc's
// validator, FLOW.DEADLOOP, "Loop must have break".
// RUN: not %clipc -T vs_5_0 -fsyntax-only %s 2>&1 | FileCheck %s --implicit-check-not=error:
// RUN: not %clipc -T vs_6_0 -fsyntax-only %s 2>&1 | FileCheck %s --implicit-check-not=error:
float4 main(float4 p : POSITION, int n : N) : SV_Position {
  if (n == 1) {
    // CHECK: [[#@LINE+1]]:5: error: the loop never ends; its condition is always true, and no `break` or `return` leaves it [endless-loop, X3696]
    while (true) p += 1;
  }
  if (n == 2) {
    // CHECK: [[#@LINE+1]]:5: error: the loop never ends
    for (;;) {
      for (int i = 0; i < n; ++i) {
        if (p.x > i) break;
      }
    }
  }
  if (n == 3) {
    // CHECK: [[#@LINE+1]]:5: error: the loop never ends
    do { p += 1; if (p.x > 1) continue; } while (1);
  }
  if (n == 4) {
    // CHECK: [[#@LINE+1]]:5: error: the loop never ends
    for (uint k = 4; k >= 0; k--) p += 1;
    // CHECK: [[#@LINE+1]]:5: error: the loop never ends
    for (int m = 0; m < 4;) p += 1;
    for (int moved = 0; moved < 4;) moved += n;
    for (uint down = 4; down > 0; down--) p += 1;
  }
  [unroll(3)] while (true) p += 1;
  while (true) {
    if (p.y > 0) break;
    p += 1;
  }
  for (int i = 0;; ++i) {
    if (p.x > i) return p;
  }
}
