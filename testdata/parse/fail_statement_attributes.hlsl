// Attributes at statements that do not take them, and two that contradict each other. What fxc and DXC
// say of each is in DXC's attributes.hlsl.
// RUN: not %clipc -T vs_5_0 %s 2>&1 | grep -v '^ ' | FileCheck %s --implicit-check-not=warning --implicit-check-not=error:
float4 main(float4 p : P, int n : N) : SV_Position {
  // CHECK: [[#@LINE+1]]:4: warning: attribute `loop` has no effect on an `if` [-Wattribute-misplaced]
  [loop] if (n > 1) p = p.yxzw;
  // CHECK-NEXT: [[#@LINE+1]]:4: warning: attribute `Branch` has no effect on a loop
  [Branch] for (int i = 0; i < 3; ++i) p = p.yxzw;
  // CHECK-NEXT: [[#@LINE+1]]:4: warning: attribute `unroll` has no effect on this statement
  [unroll] { p = p.yxzw; }
  // CHECK-NEXT: [[#@LINE+1]]:4: warning: attribute `unroll` has no effect on a `switch`
  [unroll] switch (n) { case 0: p = p.yxzw; break; }
  // CHECK-NEXT: [[#@LINE+1]]:30: warning: attribute `forcecase` has no effect on an `if`
  if (n > 2) p.x = 1; else [[forcecase]] if (n > 3) p.y = 1;
  // CHECK-NEXT: [[#@LINE+1]]:10: error: attributes `loop` and `unroll` are used together; remove one of them [attribute-conflict, X3524]
  [loop][unroll] while (n-- > 0) p = p.yxzw;
  // CHECK-NEXT: [[#@LINE+1]]:12: error: attributes `unroll` and `fastopt` are used together
  [unroll, fastopt] for (int k = 0; k < 3; ++k) p = p.yxzw;
  [loop][fastopt] do p = p.yxzw; while (n-- > 0);
  [branch] switch (n) { case 0: p = p.yxzw; break; }
  [flatten] if (n > 4) p = p.yxzw;
  [forcecase] switch (n) { case 0: p = p.yxzw; break; }
  return p;
}
