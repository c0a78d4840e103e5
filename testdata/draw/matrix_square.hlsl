// pow(m, 2) of a matrix is a product of its components, as that of a vector is: negative ones have one.
// RUN: %clipc %s -T ps_5_0 -o - | FileCheck %s --implicit-check-not=pow
// RUN: %draw compare %s -T ps_5_0
float2x2 Of(float4 p) { return (float2x2)p; }
// CHECK: matrixCompMult(m, m)
float4 main(float4 p : P) : SV_Target {
  float2x2 m = (float2x2)(p - 0.5);
  m = pow(m, 2) + pow(Of(p), 2);
  return float4(m._m00_m01_m10_m11);
}
