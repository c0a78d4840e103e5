// RUN: not %clipc -T vs_5_0 %s 2>&1 | FileCheck %s
// AUTOUPDATE
void f() {
// CHECK: fail_expressions.hlsl:[[#@LINE+3]]:11: error: unexpected `;`; expected an expression [unexpected-token, X3000]
// CHECK-NEXT:     [[#@LINE+2]] |   a = 1 + ;
// CHECK-NEXT:       |           ^
  a = 1 + ;
// CHECK-NEXT: fail_expressions.hlsl:[[#@LINE+3]]:7: error: unexpected `*`; HLSL has no pointers [no-pointers, X3000]
// CHECK-NEXT:    [[#@LINE+2]] |   b = * 2;
// CHECK-NEXT:       |       ^
  b = * 2;
// CHECK-NEXT: fail_expressions.hlsl:[[#@LINE+4]]:8: error: unexpected `->`; HLSL has no pointers [no-pointers, X3000]
// CHECK-NEXT:    [[#@LINE+3]] |   c = a->x;
// CHECK-NEXT:       |        ^~
// CHECK-NEXT:       |        .
  c = a->x;
// CHECK-NEXT: fail_expressions.hlsl:[[#@LINE+3]]:7: error: unexpected `*`; HLSL has no pointers [no-pointers, X3000]
// CHECK-NEXT:    [[#@LINE+2]] |   int *p = 1;
// CHECK-NEXT:       |       ^
  int *p = 1;
// CHECK-NEXT: fail_expressions.hlsl:[[#@LINE+3]]:12: error: unexpected `;`; expected `:` and the other value of `?` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] |   d = a ? 1;
// CHECK-NEXT:       |            ^
  d = a ? 1;
// CHECK-NEXT: fail_expressions.hlsl:[[#@LINE+3]]:7: error: unexpected `{`; expected an expression [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] |   e = {1, 2};
// CHECK-NEXT:       |       ^
  e = {1, 2};
// CHECK-NEXT: fail_expressions.hlsl:[[#@LINE+3]]:7: error: unexpected `=`; expected an expression [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] |   e + = 3;
// CHECK-NEXT:       |       ^
  e + = 3;
// CHECK-NEXT: fail_expressions.hlsl:[[#@LINE+3]]:5: error: unexpected `;`; expected the name of a member after `.` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] |   e.;
// CHECK-NEXT:       |     ^
  e.;
// CHECK-NEXT: fail_expressions.hlsl:[[#@LINE+3]]:7: error: unexpected `float`; expected an expression [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] |   e = float;
// CHECK-NEXT:       |       ^~~~~
  e = float;
// CHECK-NEXT: fail_expressions.hlsl:[[#@LINE+3]]:7: error: unexpected `return`; expected an expression [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] |   e = return;
// CHECK-NEXT:       |       ^~~~~~
  e = return;
// CHECK-NEXT: fail_expressions.hlsl:[[#@LINE+3]]:16: error: unexpected `float`; expected an integer type after `unsigned` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] |   e = unsigned float(1);
// CHECK-NEXT:       |                ^~~~~
  e = unsigned float(1);
// CHECK-NEXT: fail_expressions.hlsl:[[#@LINE+3]]:11: error: unexpected `(`; expected `;` or `=` after the name of a variable [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] |   float3 v(1, 2, 3);
// CHECK-NEXT:       |           ^
  float3 v(1, 2, 3);
// CHECK-NEXT: fail_expressions.hlsl:[[#@LINE+3]]:7: error: unexpected character; expected an expression [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] |   e = @;
// CHECK-NEXT:       |       ^
  e = @;
// CHECK-NEXT: fail_expressions.hlsl:[[#@LINE+6]]:9: error: unexpected number; expected `,` or `)` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+5]] |   g(1.5 2.5);
// CHECK-NEXT:       |         ^~~
// CHECK-NEXT: fail_expressions.hlsl:[[#@LINE+3]]:4: note: the `(` is here
// CHECK-NEXT:    [[#@LINE+2]] |   g(1.5 2.5);
// CHECK-NEXT:       |    ^
  g(1.5 2.5);
// CHECK-NEXT: fail_expressions.hlsl:[[#@LINE+6]]:7: error: unexpected string; expected `,` or `)` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+5]] |   g(1 "a");
// CHECK-NEXT:       |       ^~~
// CHECK-NEXT: fail_expressions.hlsl:[[#@LINE+3]]:4: note: the `(` is here
// CHECK-NEXT:    [[#@LINE+2]] |   g(1 "a");
// CHECK-NEXT:       |    ^
  g(1 "a");
  fine = 1;
}
