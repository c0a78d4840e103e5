// RUN: %clipc --dump=ast %s 2>&1 >%t | FileCheck %s
// Other compilers let these pass, and shaders rely on it.
struct First { float4 a; }
// CHECK: [[#@LINE-1]]:26: warning: missing `;` after the definition of struct `First` [-Wmissing-semicolon-after-type]
// CHECK: struct First
// CHECK: {{^ *\| *};$}}
struct Second { float4 a; }
// CHECK: [[#@LINE-1]]:27: warning: missing `;` after the definition of struct `Second`
float4 function() { return 0; }
enum Kind { A, B }
// CHECK: [[#@LINE-1]]:18: warning: missing `;` after the definition of enum `Kind`
cbuffer Buffer { struct { float a; } }
// CHECK: [[#@LINE-1]]:36: warning: missing `;` after the definition of a struct
struct Third { float4 a; }
// CHECK: [[#@LINE-1]]:26: warning: missing `;` after the definition of struct `Third`
[noinline]
static const float4 constant = 1;
cbuffer NeedsNone { float4 b; }
DepthStencilState nor_this { DepthEnable = false; }
// CHECK-NOT: warning
