// A struct becomes another one by a cast only, from HLSL 2021 on. Oracle: DXC's conversions-between-type-shapes-strictudt.hlsl.
// `-HV 2018` and the profiles up to 5.1 convert what has the same components.
// RUN: not %clipc -T vs_6_0 -fsyntax-only %s 2>&1 | FileCheck %s --implicit-check-not=error:
// RUN: %clipc -T vs_6_0 -HV 2018 -fsyntax-only %s 2>&1 | count 0
// RUN: %clipc -T vs_5_0 -fsyntax-only %s 2>&1 | count 0
struct A { float4 a; };
struct B { float4 b; };
struct Derived : A { float4 c; };
float4 sum(A x) { return x.a; }
A make(B b) {
  // CHECK-DAG: [[#@LINE+1]]:10: error: cannot convert `B` to `A` without a cast; from HLSL 2021 on structs are converted by casts only [cast-needed]
  return b;
}
float4 main(float4 p : POSITION) : SV_Position {
  A a = { p };
  // CHECK-DAG: [[#@LINE+1]]:9: error: cannot convert `A` to `B` without a cast
  B b = a;
  // CHECK-DAG: [[#@LINE+1]]:18: error: cannot convert `B` to `A` without a cast
  float4 c = sum(b);
  // CHECK-DAG: [[#@LINE+1]]:19: error: cannot convert `A` to `float[4]` without a cast
  float list[4] = a;
  Derived d;
  d.a = d.c = p;
  struct { float4 a; } unnamed = a;
  B cast = (B)a;
  return sum(d) + c + make((B)a).a + list[0] + unnamed.a + cast.b;
}
