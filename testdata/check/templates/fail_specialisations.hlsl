// What C++ and dxc refuse of specialisations, and what clipc does not support, is an error, not the template itself.
// RUN: not %clipc -T vs_6_0 -HV 2021 -fsyntax-only %s 2>&1 | FileCheck %s --implicit-check-not=error:
template<typename T>
T f(T x) {
  return x * 2;
}
// CHECK: [[#@LINE+1]]:5: error: `f` has template arguments; a specialisation begins with `template<>` [specialisation-without-header, X3000]
int f<int>(int x) {
  return x * 3;
}
// CHECK: [[#@LINE+1]]:19: error: `None` is not a template; a specialisation follows the template that it is of [specialisation-of-none, X3000]
template<> struct None<int> { int a; };
template<typename T> struct S {
  T a;
  T Get();
};
template<typename T> T S<T>::Get() { return a; }
// CHECK: [[#@LINE+1]]:16: error: a specialisation of the method `Get`, outside of its struct is not supported [unsupported]
template<> int S<int>::Get() { return 3; }
template<typename T, typename U> struct Pair { static float Kind() { return 0; } };
template<typename T> struct Pair<T, int> { static float Kind() { return 1; } };
template<typename T> struct Pair<int, T> { static float Kind() { return 2; } };
float4 main(float4 p : POSITION) : SV_Position {
  // CHECK: [[#@LINE+1]]:14: error: several partial specialisations of `Pair` fit, and none of them is more special than all others [ambiguous-specialisation]
  return p * Pair<int, int>::Kind() * None<int>().a;
}
