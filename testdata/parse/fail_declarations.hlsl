// RUN: not %clipc -T vs_5_0 %s 2>&1 | FileCheck %s
// AUTOUPDATE
// CHECK: fail_declarations.hlsl:[[#@LINE+3]]:21: error: unexpected `q0`; a register is one of the letters `b`, `c`, `i`, `s`, `t`, `u` and a number [bad-register, X3530]
// CHECK-NEXT:     [[#@LINE+2]] | float4 a : register(q0);
// CHECK-NEXT:       |                     ^~
float4 a : register(q0);
// CHECK-NEXT: fail_declarations.hlsl:[[#@LINE+3]]:25: error: unexpected `spaceX`; a register space is `space` and a number [bad-space]
// CHECK-NEXT:    [[#@LINE+2]] | float4 b : register(c0, spaceX);
// CHECK-NEXT:       |                         ^~~~~~
float4 b : register(c0, spaceX);
// CHECK-NEXT: fail_declarations.hlsl:[[#@LINE+3]]:21: error: unexpected `3`; a register is one of the letters `b`, `c`, `i`, `s`, `t`, `u` and a number [bad-register, X3530]
// CHECK-NEXT:    [[#@LINE+2]] | float4 c : register(3);
// CHECK-NEXT:       |                     ^
float4 c : register(3);
// CHECK-NEXT: fail_declarations.hlsl:[[#@LINE+3]]:21: error: unexpected `c99999999999`; a register is one of the letters `b`, `c`, `i`, `s`, `t`, `u` and a number [bad-register, X3530]
// CHECK-NEXT:    [[#@LINE+2]] | float4 d : register(c99999999999);
// CHECK-NEXT:       |                     ^~~~~~~~~~~~
float4 d : register(c99999999999);
cbuffer C {
// CHECK-NEXT: fail_declarations.hlsl:[[#@LINE+3]]:28: error: unexpected `q`; packoffset takes a register `c0` and at most one of its components `.x`, `.y`, `.z`, `.w` [bad-pack-offset, X3530]
// CHECK-NEXT:    [[#@LINE+2]] |   float4 e : packoffset(c0.q);
// CHECK-NEXT:       |                            ^
  float4 e : packoffset(c0.q);
// CHECK-NEXT: fail_declarations.hlsl:[[#@LINE+3]]:28: error: unexpected `xy`; packoffset takes a register `c0` and at most one of its components `.x`, `.y`, `.z`, `.w` [bad-pack-offset, X3530]
// CHECK-NEXT:    [[#@LINE+2]] |   float4 f : packoffset(c0.xy);
// CHECK-NEXT:       |                            ^~
  float4 f : packoffset(c0.xy);
// CHECK-NEXT: fail_declarations.hlsl:[[#@LINE+3]]:25: error: unexpected `t0`; packoffset takes a register `c0` and at most one of its components `.x`, `.y`, `.z`, `.w` [bad-pack-offset, X3530]
// CHECK-NEXT:    [[#@LINE+2]] |   float4 g : packoffset(t0);
// CHECK-NEXT:       |                         ^~
  float4 g : packoffset(t0);
}
// CHECK-NEXT: fail_declarations.hlsl:[[#@LINE+3]]:12: error: unexpected `;`; expected a semantic, `register(...)` or `packoffset(...)` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] | float4 h : ;
// CHECK-NEXT:       |            ^
float4 h : ;
// CHECK-NEXT: fail_declarations.hlsl:[[#@LINE+3]]:12: error: unexpected number; expected a semantic, `register(...)` or `packoffset(...)` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] | float4 i : 3.0;
// CHECK-NEXT:       |            ^~~
float4 i : 3.0;
// CHECK-NEXT: fail_declarations.hlsl:[[#@LINE+3]]:11: error: unexpected `(`; expected brackets around the attribute, `[clipplanes(...)]` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] | clipplanes(a, b)
// CHECK-NEXT:       |           ^
clipplanes(a, b)
float4 lost() : SV_Position { return 0; }
// CHECK-NEXT: fail_declarations.hlsl:[[#@LINE+6]]:12: error: unexpected `B`; expected `,` or `}` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+5]] | enum E { A B };
// CHECK-NEXT:       |            ^
// CHECK-NEXT: fail_declarations.hlsl:[[#@LINE+3]]:8: note: the `{` is here
// CHECK-NEXT:    [[#@LINE+2]] | enum E { A B };
// CHECK-NEXT:       |        ^
enum E { A B };
// CHECK-NEXT: fail_declarations.hlsl:[[#@LINE+3]]:13: error: unexpected `float`; expected `{` and the members of the namespace [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] | namespace N float x;
// CHECK-NEXT:       |             ^~~~~
namespace N float x;
// CHECK-NEXT: fail_declarations.hlsl:[[#@LINE+3]]:6: error: unexpected `;`; expected a name [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] | using;
// CHECK-NEXT:       |      ^
using;
// CHECK-NEXT: fail_declarations.hlsl:[[#@LINE+6]]:20: error: unexpected `;`; expected `>` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+5]] | template<typename T;
// CHECK-NEXT:       |                    ^
// CHECK-NEXT: fail_declarations.hlsl:[[#@LINE+3]]:9: note: the `<` is here
// CHECK-NEXT:    [[#@LINE+2]] | template<typename T;
// CHECK-NEXT:       |         ^
template<typename T;
// CHECK-NEXT: fail_declarations.hlsl:[[#@LINE+3]]:13: error: unexpected `=`; expected `{` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] | technique T = 1;
// CHECK-NEXT:       |             ^
technique T = 1;
// CHECK-NEXT: fail_declarations.hlsl:[[#@LINE+3]]:1: error: unexpected `+`; expected a declaration [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+2]] | +;
// CHECK-NEXT:       | ^
+;
// CHECK-NEXT: fail_declarations.hlsl:[[#@LINE+3]]:1: error: unexpected `}`; no `{` is open here [stray-brace, X3000]
// CHECK-NEXT:    [[#@LINE+2]] | }
// CHECK-NEXT:       | ^
}
float4 fine;
