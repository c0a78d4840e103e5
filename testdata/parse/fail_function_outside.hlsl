// Statements outside a function in which a function starts end there; the rest is read once. This took forever.
// RUN: not %clipc -T vs_5_0 %s -o %t 2>&1 | FileCheck %s
float4 a;
// CHECK: error: unexpected `}`; no `{` is open here [stray-brace, X3000]
}
// CHECK: error: unexpected `x`; a statement must be inside a function [statement-outside-function, X3000]
x += 1;
for (;;) {
  // CHECK: error: function `main` starts inside the body of another; a `}` is missing before it [function-inside-function, X3000]
  float4 main(float4 p : POSITION) : SV_Position {
    return p;
  }
