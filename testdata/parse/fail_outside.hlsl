// RUN: not %clipc -T vs_5_0 %s 2>&1 | FileCheck %s
float4 main(float4 p : POSITION) : SV_Position {
  if (p.x > 1) { p.y = 1; } }
  p.z = 2;
// CHECK: [[#@LINE-1]]:3: error: unexpected `p`; a statement must be inside a function [statement-outside-function, X3000]
  if (p.x > 2) { p.y = 2; } else p.y = 3;
  return p;
}
float4 second() { return 1; }
}
// CHECK: [[#@LINE-1]]:1: error: unexpected `}`; no `{` is open here [stray-brace, X3000]
// CHECK-NOT: error
