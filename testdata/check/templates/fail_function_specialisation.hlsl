// An explicit specialisation of a function template is refused, not taken for the general function: dxc calls it, and f<int>(5) is 15.
// RUN: not %clipc -T vs_6_0 -HV 2021 -fsyntax-only %s 2>&1 | FileCheck %s
template<typename T>
T f(T x) {
  return x * 2;
}
template<>
// CHECK: [[#@LINE+1]]:5: error: a specialisation of the function template `f` is not supported [unsupported]
int f<int>(int x) {
  return x * 3;
}
float4 main(float4 p : POSITION) : SV_Position { return p * f<int>(5); }
