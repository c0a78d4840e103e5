// A prototype inside a function is one of the function around it (DXC's CodeGenSPIRV/fn.forward-declaration.hlsl).
// RUN: %clipc -T ps_6_0 %s -o - | FileCheck %s
// RUN: %clipc -T ps_5_0 %s -o - | FileCheck %s
// RUN: %draw compare %s -T ps_6_0
float4 main(float4 p : P) : SV_Target {
  float Twice(float f);
  // CHECK: Twice(vs_P0.x)
  return Twice(p.x);
}
float Twice(float f) { return f * 2; }
