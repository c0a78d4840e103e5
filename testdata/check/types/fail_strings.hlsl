// A string is a value that only effects use.
// RUN: not %clipc -T vs_5_0 %s -o %t 2>&1 | FileCheck %s
// AUTOUPDATE
// CHECK: fail_strings.hlsl:[[#@LINE+3]]:37: error: `name` is a string; a shader computes with numbers only [string-used, X3020]
// CHECK-NEXT:     [[#@LINE+2]] | struct Named { float4 value; string name; };
// CHECK-NEXT:       |                                     ^~~~
struct Named { float4 value; string name; };
Named named;
// CHECK-NEXT: fail_strings.hlsl:[[#@LINE+3]]:15: error: `words` is a string; a shader computes with numbers only [string-used, X3020]
// CHECK-NEXT:     [[#@LINE+2]] | static string words[2] = {"a", "b"};
// CHECK-NEXT:       |               ^~~~~
static string words[2] = {"a", "b"};
// CHECK-NEXT: fail_strings.hlsl:[[#@LINE+3]]:8: error: `Name` is a string; a shader computes with numbers only [string-used, X3020]
// CHECK-NEXT:    [[#@LINE+2]] | string Name() { return "a"; }
// CHECK-NEXT:       |        ^~~~
string Name() { return "a"; }
// CHECK-NEXT: fail_strings.hlsl:[[#@LINE+3]]:21: error: `name` is a string; a shader computes with numbers only [string-used, X3020]
// CHECK-NEXT:    [[#@LINE+2]] | float4 Drawn(string name, float4 p) { return p; }
// CHECK-NEXT:       |                     ^~~~
float4 Drawn(string name, float4 p) { return p; }
float4 main(float4 p : POSITION) : SV_Position {
  string unused = "x";
  words[1];
  Name();
  return named.value + Drawn("x", p);
}
