// RUN: not %clipc -T vs_6_0 -HV 2021 %s -o - 2>&1 | FileCheck %s
struct Scale {
  float k;
  float operator()(float x) { return x * k; }
};
struct Outer { Scale inner; };
float4 main(float4 p : POSITION) : SV_Position {
  float f = 1;
  Outer o;
  o.inner.k = 2;
  // CHECK: [[#@LINE+1]]:3: error: `f` is not a function [not-callable, X3005]
  f(1);
  // CHECK: [[#@LINE+1]]:5: error: `inner` is not a function [not-callable, X3005]
  o.inner(p, p, p);
  return p;
}
