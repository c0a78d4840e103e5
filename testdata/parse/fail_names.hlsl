// RUN: not %clipc -T vs_5_0 %s 2>&1 | FileCheck %s
// AUTOUPDATE
// CHECK: fail_names.hlsl:[[#@LINE+3]]:8: error: unexpected `in`; a keyword cannot name a variable [reserved-name, X3000]
// CHECK-NEXT:     [[#@LINE+2]] | float4 in : POSITION;
// CHECK-NEXT:       |        ^~
float4 in : POSITION;
// CHECK-NEXT: fail_names.hlsl:[[#@LINE+3]]:19: error: unexpected `return`; a keyword cannot name a field [reserved-name, X3000]
// CHECK-NEXT:    [[#@LINE+2]] | struct S { float4 return; float4 good; };
// CHECK-NEXT:       |                   ^~~~~~
struct S { float4 return; float4 good; };
// CHECK-NEXT: fail_names.hlsl:[[#@LINE+3]]:6: error: unexpected `float`; a keyword cannot name a function [reserved-name, X3000]
// CHECK-NEXT:    [[#@LINE+2]] | void float(int a) {}
// CHECK-NEXT:       |      ^~~~~
void float(int a) {}
// CHECK-NEXT: fail_names.hlsl:[[#@LINE+3]]:16: error: unexpected `if`; a keyword cannot name a type [reserved-name, X3000]
// CHECK-NEXT:    [[#@LINE+2]] | typedef float4 if;
// CHECK-NEXT:       |                ^~
typedef float4 if;
// CHECK-NEXT: fail_names.hlsl:[[#@LINE+3]]:9: error: unexpected `switch`; a keyword cannot name a constant buffer [reserved-name, X3000]
// CHECK-NEXT:    [[#@LINE+2]] | cbuffer switch { float a; }
// CHECK-NEXT:       |         ^~~~~~
cbuffer switch { float a; }
// CHECK-NEXT: fail_names.hlsl:[[#@LINE+3]]:13: error: unexpected `while`; a keyword cannot name a value of an enum [reserved-name, X3000]
// CHECK-NEXT:    [[#@LINE+2]] | enum E { A, while };
// CHECK-NEXT:       |             ^~~~~
enum E { A, while };
// CHECK-NEXT: fail_names.hlsl:[[#@LINE+3]]:20: error: unexpected `out`; a keyword cannot name a parameter [reserved-name, X3000]
// CHECK-NEXT:    [[#@LINE+2]] | float4 main(float4 out) : SV_Position {
// CHECK-NEXT:       |                    ^~~
float4 main(float4 out) : SV_Position {
// CHECK-NEXT: fail_names.hlsl:[[#@LINE+3]]:7: error: unexpected `for`; a keyword cannot name a variable [reserved-name, X3000]
// CHECK-NEXT:    [[#@LINE+2]] |   int for = 2;
// CHECK-NEXT:       |       ^~~
  int for = 2;
// CHECK-NEXT: fail_names.hlsl:[[#@LINE+3]]:10: error: unexpected `=`; expected the name of a variable [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] |   float4 = 1;
// CHECK-NEXT:       |          ^
  float4 = 1;
  return 1;
}
