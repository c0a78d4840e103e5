// A product whose first factor is read into a variable has its last factor where it was: what that reads must not wait for a later
// write.
// RUN: %clipc -T vs_6_0 %s --dump-after=lower-operand-order | FileCheck %s
// RUN: %draw compare %s -T vs_6_0
float4 main(float4 p : POSITION) : SV_Position {
  float4 product = mul((float4x4)(p = p.wzyx).y, p - 1) - (p = float4(1, 2, 3, 4)).wxyz;
  return product + p;
}
// CHECK: old_p = p
// CHECK-SAME: (p = float4(1.0, 2.0, 3.0, 4.0))
