// Arguments of alias templates that are missing, too many or wrong.
// RUN: not %clipc %s -T ps_6_0 -fsyntax-only 2>&1 | FileCheck %s
template<typename T> using V = vector<T, 4>;
// CHECK: [[#@LINE+1]]:34: error: `Own` is not a type; a name must be declared before its use [unknown-type, X3000]
template<typename T> using Own = Own<T>;
float4 main(float4 p : P) : SV_Target {
  // CHECK: [[#@LINE+1]]:3: error: `V` is used without its template arguments [missing-type-argument, X3000]
  V a = p;
  // CHECK: [[#@LINE+1]]:3: error: too many template arguments for `V`; it takes at most 1 [too-many-type-arguments, X3000]
  V<float, 4> b = p;
  Own<float> c = p;
  return a + b + c;
}
