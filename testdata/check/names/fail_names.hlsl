// What is said of names that mean nothing, or the wrong thing.
// RUN: not %clipc -T vs_5_0 -E main %s 2>&1 | FileCheck %s
struct Light { float3 direction; };
enum class Level { kLow };
namespace space { float f() { return 1; } }
float unlit(float x) { return x; }
float twice;
// CHECK: [[#@LINE+1]]:7: error: `twice` is declared twice in one scope [redefinition, X3003]
float twice;
float4 main(float4 position : POSITION) : SV_Position {
  // CHECK: [[#@LINE+1]]:13: error: `positoin` is not declared; did you mean `position`? [undeclared-name, X3004]
  float a = positoin.x;
  // CHECK: [[#@LINE+1]]:13: error: `beyond` is not declared; a name must be declared before its use [undeclared-name, X3004]
  float b = beyond;
  // CHECK: note: `beyond` is declared here
  // CHECK: [[#@LINE+1]]:13: error: there is no function `unlti`; did you mean `unlit`? [unknown-function, X3004]
  float c = unlti(1);
  // CHECK: [[#@LINE+1]]:13: error: there is no function `normalise`; did you mean `normalize`? [unknown-function, X3004]
  float d = normalise(position).x;
  // CHECK: [[#@LINE+1]]:3: error: `Ligth` is not a type; did you mean `Light`? [unknown-type, X3000]
  Ligth e;
  // CHECK: [[#@LINE+1]]:13: error: type `Light` is used as a value [type-as-value, X3005]
  float f = Light;
  // CHECK: [[#@LINE+1]]:13: error: function `unlit` is used as a value; only a call of it has a value [function-as-value, X3005]
  float g = unlit;
  // CHECK: [[#@LINE+1]]:13: error: namespace `space` is used as a value [namespace-as-value, X3005]
  float h = space;
  // CHECK: [[#@LINE+1]]:13: error: `nowhere` before `::` is not a namespace, struct or enum [no-such-scope, X3004]
  float i = nowhere::f();
  // CHECK: [[#@LINE+1]]:13: error: `a` is not a function [not-callable, X3005]
  float j = a(1);
  // CHECK: [[#@LINE+1]]:13: error: `kLow` is not declared [undeclared-name, X3004]
  float k = kLow;
  // CHECK: [[#@LINE+1]]:9: error: `a` is declared twice in one scope [redefinition, X3003]
  float a = 2;
  // What has an error says nothing more.
  // CHECK-NOT: error
  return e.direction + a + b + c + d + f;
}
float beyond;
