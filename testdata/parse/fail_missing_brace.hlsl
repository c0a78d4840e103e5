// RUN: not %clipc -T vs_5_0 %s 2>&1 | FileCheck %s
// AUTOUPDATE
float4 first(float x) {
  if (x > 1) {
    x = 2;
  return x;
}

// CHECK: fail_missing_brace.hlsl:[[#@LINE+3]]:8: error: function `second` starts inside the body of another; a `}` is missing before it [function-inside-function, X3000]
// CHECK-NEXT:    [[#@LINE+2]] | float4 second() : SV_Position {
// CHECK-NEXT:       |        ^~~~~~
float4 second() : SV_Position {
  return first(1);

// CHECK-NEXT: fail_missing_brace.hlsl:[[#@LINE+6]]:1: error: unexpected `cbuffer`; expected `}` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+5]] | cbuffer Scene { float4 plane; }
// CHECK-NEXT:       | ^~~~~~~
// CHECK-NEXT: fail_missing_brace.hlsl:[[#@LINE-6]]:31: note: the `{` is here
// CHECK-NEXT:    [[#@LINE-7]] | float4 second() : SV_Position {
// CHECK-NEXT:       |                               ^
cbuffer Scene { float4 plane; }
struct Vertex {
// CHECK-NEXT: fail_missing_brace.hlsl:[[#@LINE+6]]:30: error: unexpected end of file; expected `}` [unexpected-token, X3000]
// CHECK-NEXT:    [[#@LINE+5]] |   float4 position : POSITION;
// CHECK-NEXT:       |                              ^
// CHECK-NEXT: fail_missing_brace.hlsl:[[#@LINE-4]]:15: note: the `{` is here
// CHECK-NEXT:    [[#@LINE-5]] | struct Vertex {
// CHECK-NEXT:       |               ^
  float4 position : POSITION;
