// RUN: not %clipc -T vs_5_0 -E main %s 2>&1 | FileCheck %s
float two(int x, float y) { return 1; }
float two(float x, int y) { return 2; }
float one(float3 x) { return 1; }
float body_missing(float x);
float written_twice(float x) { return x; }
// CHECK-DAG: [[#@LINE+1]]:7: error: `written_twice(float)` has two bodies; a function is defined once [function-redefinition, X3003]
float written_twice(float x) { return x; }
float of_type(float x);
// CHECK-DAG: [[#@LINE+1]]:8: error: `of_type(float)` returns `float2` here and `float` elsewhere; overloads differ in their parameters [return-type-differs, X3116]
float2 of_type(float x) { return x; }
// CHECK-DAG: [[#@LINE+1]]:7: error: not every path through `falls` returns a value; its type is `float` [not-all-paths-return, X3507]
float falls(float x) { if (x > 0) x = 1; }
// CHECK-DAG: [[#@LINE+1]]:25: error: `returns` returns a value; its type is `void` [return-from-void, X3079]
void returns() { return 1; }
// CHECK-DAG: [[#@LINE+1]]:17: error: `return` without a value in `empty`; its type is `float` [return-without-value, X3080]
float empty() { return; }
float ping(float x);
// CHECK-DAG: [[#@LINE+1]]:38: error: recursive call of `ping`; the functions of a shader cannot recurse [recursion, X3500]
float pong(float x) { return x > 0 ? ping(x - 1) : 0; }
float ping(float x) { return pong(x); }
float4 main(float4 position : POSITION) : SV_Position {
  // CHECK-DAG: [[#@LINE+1]]:3: error: call of `two(int, int)` fits several functions equally well [ambiguous-call, X3067]
  two(1, 1);
  // CHECK-DAG: note: candidate: `two(float, int)`
  // CHECK-DAG: [[#@LINE+1]]:3: error: no function `one` takes 2 arguments [wrong-argument-count, X3013]
  one(position.xyz, 1);
  // CHECK-DAG: [[#@LINE+1]]:3: error: no function `one` takes (float2) [no-matching-function, X3013]
  one(position.xy);
  // CHECK-DAG: [[#@LINE+1]]:3: error: `body_missing(float)` is called but has no body [function-without-body, X3000]
  body_missing(1);
  written_twice(1);
  of_type(1);
  falls(1);
  returns();
  empty();
  ping(1);
  return position;
}
