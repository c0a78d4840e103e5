// An enum class is a type of its own: a function of it, one of another, and one of a number are overloads.
// RUN: %clipc %s -T vs_6_0 -o - | FileCheck %s
// RUN: %draw compare %s -T vs_6_0
enum class A { X, Y };
enum class B { X, Y };
float Of(int a) { return 2; }
float Of(A a) { return 5; }
float Of(B a) { return 7; }
// CHECK: return 2.0;
// CHECK: return 5.0;
// CHECK: return 7.0;
// CHECK: vec4(Of(in_I0), Of_2(1), Of_3(b), Of_2(in_I0))
float4 main(float4 p : P, int i : I) : SV_Position {
  B b = B::X;
  return float4(Of(i), Of(A::Y), Of(b), Of((A)i));
}
