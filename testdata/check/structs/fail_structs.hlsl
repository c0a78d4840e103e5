// RUN: not %clipc -T vs_5_0 -E main %s 2>&1 | FileCheck %s
struct S {
  float4 position;
  float4 normal;
  // CHECK-DAG: [[#@LINE+1]]:10: error: `normal` is declared twice in one scope [redefinition, X3003]
  float3 normal;
  // CHECK-DAG: [[#@LINE+1]]:29: error: `position` is used without an object; it belongs to each object of its struct [field-without-object, X3004]
  static float f() { return position.x; }
};
// CHECK-DAG: [[#@LINE+1]]:12: error: `float4` is not a struct, class or interface; only those can be inherited from [base-not-struct, X3000]
struct T : float4 { float x; };
// CHECK-DAG: [[#@LINE+1]]:18: error: `x` belongs to each object of its struct and has no value here; initialise the objects, or declare it `static const` [field-initialised]
struct U { float x = 1; };
float4 main(float4 position : POSITION) : SV_Position {
  S s;
  T t;
  U u;
  // CHECK-DAG: [[#@LINE+1]]:5: error: `S` has no member `positoin`; did you mean `position`? [no-such-member, X3018]
  s.positoin = position;
  // CHECK-DAG: [[#@LINE+1]]:5: error: `S` has no member `shade` [no-such-member, X3018]
  s.shade(1);
  // CHECK-DAG: [[#@LINE+1]]:5: error: `normal` is not a function [not-callable, X3005]
  s.normal(1);
  // CHECK-DAG: [[#@LINE+1]]:13: error: `S` has no member `T::position` [no-such-member, X3018]
  s += s.T::position;
  return S::f();
}
