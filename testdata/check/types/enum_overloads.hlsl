// An enum that is not a class is a type of its own for overloads, and becomes a number only where no function takes the enum ([over.ics.rank]
// of C++, which DXC follows). What is computed of it is a number.
// RUN: %clipc %s -T vs_6_0 -o - | FileCheck %s
// RUN: %draw compare %s -T vs_6_0
enum A { X, Y };
enum B { Z };
float Of(int a) { return 2; }
float Of(A a) { return 5; }
float Number(uint a) { return 1; }
float Number(int a) { return 3; }
// CHECK: return 5.0;
// CHECK: return 2.0;
// CHECK: vec4(Of(1), Of_2(in_I0) + Of_2(1 + 1), Of(a), Of_2(0) + Number({{.*}}))
float4 main(float4 p : P, int i : I) : SV_Position {
  A a = X;
  return float4(Of(Y), Of(i) + Of(Y + 1), Of(a), Of(Z) + Number(Y));
}
