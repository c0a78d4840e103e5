// RUN: not %clipc -T vs_5_0 %s 2>&1 | FileCheck %s
// AUTOUPDATE
// CHECK: fail_brackets.hlsl:[[#@LINE+6]]:17: error: unexpected `]`; expected `,` or `)` [unexpected-token, X3000]
// CHECK-NEXT:     [[#@LINE+5]] | [clipplanes(a, b]
// CHECK-NEXT:       |                 ^
// CHECK-NEXT: fail_brackets.hlsl:[[#@LINE+3]]:12: note: the `(` is here
// CHECK-NEXT:     [[#@LINE+2]] | [clipplanes(a, b]
// CHECK-NEXT:       |            ^
[clipplanes(a, b]
// CHECK-NEXT: fail_brackets.hlsl:[[#@LINE+6]]:51: error: unexpected `{`; expected `,` or `)` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+5]] | float4 unclosed(float4 p : POSITION : SV_Position {
// CHECK-NEXT:       |                                                   ^
// CHECK-NEXT: fail_brackets.hlsl:[[#@LINE+3]]:16: note: the `(` is here
// CHECK-NEXT:    [[#@LINE+2]] | float4 unclosed(float4 p : POSITION : SV_Position {
// CHECK-NEXT:       |                ^
float4 unclosed(float4 p : POSITION : SV_Position {
  return p;
}
// CHECK-NEXT: fail_brackets.hlsl:[[#@LINE+6]]:17: error: unexpected `float`; expected `,` or `)` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+5]] | float f(float a float b) { return a; }
// CHECK-NEXT:       |                 ^~~~~
// CHECK-NEXT: fail_brackets.hlsl:[[#@LINE+3]]:8: note: the `(` is here
// CHECK-NEXT:    [[#@LINE+2]] | float f(float a float b) { return a; }
// CHECK-NEXT:       |        ^
float f(float a float b) { return a; }
// CHECK-NEXT: fail_brackets.hlsl:[[#@LINE+3]]:17: error: unexpected `)`; expected a parameter [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] | float g(float a,) { return a; }
// CHECK-NEXT:       |                 ^
float g(float a,) { return a; }
// CHECK-NEXT: fail_brackets.hlsl:[[#@LINE+6]]:25: error: unexpected `items`; expected `>` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+5]] | StructuredBuffer<float4 items;
// CHECK-NEXT:       |                         ^~~~~
// CHECK-NEXT: fail_brackets.hlsl:[[#@LINE+3]]:17: note: the `<` is here
// CHECK-NEXT:    [[#@LINE+2]] | StructuredBuffer<float4 items;
// CHECK-NEXT:       |                 ^
StructuredBuffer<float4 items;
// CHECK-NEXT: fail_brackets.hlsl:[[#@LINE+9]]:33: error: unexpected `}`; expected `>` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+8]] | float4 tint <string name = "x"; } = 1;
// CHECK-NEXT:       |                                 ^
// CHECK-NEXT: fail_brackets.hlsl:[[#@LINE+6]]:13: note: the `<` is here
// CHECK-NEXT:    [[#@LINE+5]] | float4 tint <string name = "x"; } = 1;
// CHECK-NEXT:       |             ^
// CHECK-NEXT: fail_brackets.hlsl:[[#@LINE+3]]:35: error: unexpected `=`; expected a declaration [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] | float4 tint <string name = "x"; } = 1;
// CHECK-NEXT:       |                                   ^
float4 tint <string name = "x"; } = 1;
void body() {
// CHECK-NEXT: fail_brackets.hlsl:[[#@LINE+6]]:21: error: unexpected `;`; expected `,` or `)` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+5]] |   float a = dot(p, p;
// CHECK-NEXT:       |                     ^
// CHECK-NEXT: fail_brackets.hlsl:[[#@LINE+3]]:16: note: the `(` is here
// CHECK-NEXT:    [[#@LINE+2]] |   float a = dot(p, p;
// CHECK-NEXT:       |                ^
  float a = dot(p, p;
// CHECK-NEXT: fail_brackets.hlsl:[[#@LINE+6]]:19: error: unexpected `;`; expected `)` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+5]] |   float b = (a + 1;
// CHECK-NEXT:       |                   ^
// CHECK-NEXT: fail_brackets.hlsl:[[#@LINE+3]]:13: note: the `(` is here
// CHECK-NEXT:    [[#@LINE+2]] |   float b = (a + 1;
// CHECK-NEXT:       |             ^
  float b = (a + 1;
// CHECK-NEXT: fail_brackets.hlsl:[[#@LINE+6]]:19: error: unexpected `2`; expected `,` or `}` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+5]] |   float c[2] = {1 2};
// CHECK-NEXT:       |                   ^
// CHECK-NEXT: fail_brackets.hlsl:[[#@LINE+3]]:16: note: the `{` is here
// CHECK-NEXT:    [[#@LINE+2]] |   float c[2] = {1 2};
// CHECK-NEXT:       |                ^
  float c[2] = {1 2};
// CHECK-NEXT: fail_brackets.hlsl:[[#@LINE+6]]:10: error: unexpected `;`; expected `]` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+5]] |   c[0 = 1;
// CHECK-NEXT:       |          ^
// CHECK-NEXT: fail_brackets.hlsl:[[#@LINE+3]]:4: note: the `[` is here
// CHECK-NEXT:    [[#@LINE+2]] |   c[0 = 1;
// CHECK-NEXT:       |    ^
  c[0 = 1;
// CHECK-NEXT: fail_brackets.hlsl:[[#@LINE+6]]:13: error: unexpected `{`; expected `)` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+5]] |   if (a > 3 { b = 1; }
// CHECK-NEXT:       |             ^
// CHECK-NEXT: fail_brackets.hlsl:[[#@LINE+3]]:6: note: the `(` is here
// CHECK-NEXT:    [[#@LINE+2]] |   if (a > 3 { b = 1; }
// CHECK-NEXT:       |      ^
  if (a > 3 { b = 1; }
// CHECK-NEXT: fail_brackets.hlsl:[[#@LINE+6]]:30: error: unexpected `{`; expected `)` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+5]] |   for (int i = 0; i < 3; i++ { b = 2; }
// CHECK-NEXT:       |                              ^
// CHECK-NEXT: fail_brackets.hlsl:[[#@LINE+3]]:7: note: the `(` is here
// CHECK-NEXT:    [[#@LINE+2]] |   for (int i = 0; i < 3; i++ { b = 2; }
// CHECK-NEXT:       |       ^
  for (int i = 0; i < 3; i++ { b = 2; }
// CHECK-NEXT: fail_brackets.hlsl:[[#@LINE+3]]:9: error: unexpected `a`; expected `(` after `while` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] |   while a { }
// CHECK-NEXT:       |         ^
  while a { }
// CHECK-NEXT: fail_brackets.hlsl:[[#@LINE+3]]:11: error: unexpected `)`; expected an expression [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] |   d = f(1,);
// CHECK-NEXT:       |           ^
  d = f(1,);
}
