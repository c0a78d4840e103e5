// RUN: not %clipc -T vs_5_0 %s 2>&1 | FileCheck %s
// AUTOUPDATE
// CHECK: fail_semicolon.hlsl:[[#@LINE+4]]:28: error: missing `;` after the declaration of `map` [missing-semicolon, X3000]
// CHECK-NEXT:     [[#@LINE+3]] | Texture2D map : register(t0)
// CHECK-NEXT:       |                            ^
// CHECK-NEXT:       |                            );
Texture2D map : register(t0)
// CHECK-NEXT: fail_semicolon.hlsl:[[#@LINE+4]]:26: error: missing `;` after the declaration of `view` [missing-semicolon, X3000]
// CHECK-NEXT:    [[#@LINE+3]] | cbuffer Scene { float4x4 view float4 plane; }
// CHECK-NEXT:       |                          ^~~~
// CHECK-NEXT:       |                          view;
cbuffer Scene { float4x4 view float4 plane; }
// CHECK-NEXT: fail_semicolon.hlsl:[[#@LINE+4]]:16: error: missing `;` after the typedef [missing-semicolon, X3000]
// CHECK-NEXT:    [[#@LINE+3]] | typedef float4 Color
// CHECK-NEXT:       |                ^~~~~
// CHECK-NEXT:       |                Color;
typedef float4 Color
float4 main(float4 p : POSITION) : SV_Position {
// CHECK-NEXT: fail_semicolon.hlsl:[[#@LINE+3]]:18: error: missing `;` after the declaration of `a` [missing-semicolon, X3000]
// CHECK-NEXT:    [[#@LINE+2]] |   float4 a = p * 2
// CHECK-NEXT:       |                  ^
  float4 a = p * 2
// CHECK-NEXT: fail_semicolon.hlsl:[[#@LINE+4]]:18: error: missing `;` after the expression [missing-semicolon, X3000]
// CHECK-NEXT:    [[#@LINE+3]] |   a = mul(p, view)
// CHECK-NEXT:       |                  ^
// CHECK-NEXT:       |                  );
  a = mul(p, view)
// CHECK-NEXT: fail_semicolon.hlsl:[[#@LINE+3]]:11: error: unexpected `2`; expected `;` after the expression [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] |   a.x = 1 2;
// CHECK-NEXT:       |           ^
  a.x = 1 2;
// CHECK-NEXT: fail_semicolon.hlsl:[[#@LINE+6]]:14: error: unexpected `float4`; expected an expression [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+5]] |   float4 b = float4{1, 2};
// CHECK-NEXT:       |              ^~~~~~
// CHECK-NEXT: fail_semicolon.hlsl:[[#@LINE+3]]:24: error: missing `;` after the expression [missing-semicolon, X3000]
// CHECK-NEXT:    [[#@LINE+2]] |   float4 b = float4{1, 2};
// CHECK-NEXT:       |                        ^
  float4 b = float4{1, 2};
// CHECK-NEXT: fail_semicolon.hlsl:[[#@LINE+4]]:16: error: missing `;` after `break` [missing-semicolon, X3000]
// CHECK-NEXT:    [[#@LINE+3]] |   if (a.x > 1) break
// CHECK-NEXT:       |                ^~~~~
// CHECK-NEXT:       |                break;
  if (a.x > 1) break
// CHECK-NEXT: fail_semicolon.hlsl:[[#@LINE+4]]:10: error: missing `;` after `return` [missing-semicolon, X3000]
// CHECK-NEXT:    [[#@LINE+3]] |   return a
// CHECK-NEXT:       |          ^
// CHECK-NEXT:       |          a;
  return a
}
// CHECK-NEXT: fail_semicolon.hlsl:[[#@LINE+3]]:17: error: unexpected `return`; expected `{` or `;` after the header of `broken` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] | float4 broken() return 1; }
// CHECK-NEXT:       |                 ^~~~~~
float4 broken() return 1; }
