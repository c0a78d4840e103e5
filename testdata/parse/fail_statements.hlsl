// RUN: not %clipc -T vs_5_0 %s 2>&1 | FileCheck %s
// AUTOUPDATE
void f() {
  if (a) b = 1; c = 2;
// CHECK: fail_statements.hlsl:[[#@LINE+3]]:3: error: `else` without `if`; only one statement or block may be between them [else-without-if, X3000]
// CHECK-NEXT:     [[#@LINE+2]] |   else d = 1;
// CHECK-NEXT:       |   ^~~~
  else d = 1;
  switch (a) {
// CHECK-NEXT: fail_statements.hlsl:[[#@LINE+3]]:12: error: unexpected `b`; expected `:` after the value of `case` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] |     case 1 b = 2; break;
// CHECK-NEXT:       |            ^
    case 1 b = 2; break;
// CHECK-NEXT: fail_statements.hlsl:[[#@LINE+3]]:13: error: unexpected `b`; expected `:` after `default` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] |     default b = 3;
// CHECK-NEXT:       |             ^
    default b = 3;
  }
// CHECK-NEXT: fail_statements.hlsl:[[#@LINE+3]]:14: error: unexpected `b`; expected `{` after `switch (...)` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] |   switch (a) b = 1;
// CHECK-NEXT:       |              ^
  switch (a) b = 1;
// CHECK-NEXT: fail_statements.hlsl:[[#@LINE+3]]:10: error: unexpected `until`; expected `while` after the body of `do` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] |   do { } until (a);
// CHECK-NEXT:       |          ^~~~~
  do { } until (a);
// CHECK-NEXT: fail_statements.hlsl:[[#@LINE+3]]:13: error: unexpected `)`; expected `;` after the expression [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] |   for (a = 0) b = 1;
// CHECK-NEXT:       |             ^
  for (a = 0) b = 1;
// CHECK-NEXT: fail_statements.hlsl:[[#@LINE+3]]:24: error: unexpected `)`; expected `;` after the condition of `for` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] |   for (int i = 0; i < 3) b = 1;
// CHECK-NEXT:       |                        ^
  for (int i = 0; i < 3) b = 1;
  [unroll
// CHECK-NEXT: fail_statements.hlsl:[[#@LINE+9]]:3: error: unexpected `for`; expected `]` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+8]] |   for (;;) { }
// CHECK-NEXT:       |   ^~~
// CHECK-NEXT: fail_statements.hlsl:[[#@LINE-4]]:3: note: the `[` is here
// CHECK-NEXT:    [[#@LINE-5]] |   [unroll
// CHECK-NEXT:       |   ^
// CHECK-NEXT: fail_statements.hlsl:[[#@LINE+3]]:10: error: unexpected `)`; expected an expression [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] |   for (;;) { }
// CHECK-NEXT:       |          ^
  for (;;) { }
// CHECK-NEXT: fail_statements.hlsl:[[#@LINE+3]]:4: error: unexpected `4`; expected the name of an attribute [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] |   [4] b = 1;
// CHECK-NEXT:       |    ^
  [4] b = 1;
// CHECK-NEXT: fail_statements.hlsl:[[#@LINE+3]]:10: error: unexpected `}`; expected a statement after `if (...)` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] |   if (a) }
// CHECK-NEXT:       |          ^
  if (a) }
