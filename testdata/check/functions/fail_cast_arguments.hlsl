// RUN: not %clipc -T vs_5_0 %s 2>&1 | FileCheck %s
struct A { float4 p; };
struct B { float4 p; float4 d; };
cbuffer C { B set; };
void change(inout A v) { v.p *= 2; }
float4 main(float4 p : POSITION) : SV_Position {
  const B fixed = { p, p };
  // CHECK: [[#@LINE+1]]:13: error: `set` is set by the application; a shader cannot assign to it; `static` makes a variable of the shader's own [uniform-assigned, X3025]
  change((A)set);
  // CHECK: [[#@LINE+1]]:13: error: `fixed` is constant; it cannot be assigned to [const-assigned, X3025]
  change((A)fixed);
  return p;
}
