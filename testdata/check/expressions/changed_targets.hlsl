// From 6.0 on the result of an assignment or of a prefix increment can be assigned to, as in C++ (DXC's
// CodeGenSPIRV/unary-op.prefix-inc.hlsl). A right side is evaluated first.
// RUN: %clipc -T ps_6_0 %s -o - | FileCheck %s
// RUN: %draw compare %s -T ps_6_0
int Next(inout int n) { return ++n; }
float4 main(float4 p : P) : SV_Target {
  int i = (int)p.x;
  int a[2] = {i, 2};
  // CHECK: ++i;
  // CHECK-NEXT: ++i;
  ++(++i);
  // CHECK-NEXT: i += 2;
  // CHECK-NEXT: i *= 3;
  (i += 2) *= 3;
  --(a[1] = 4);
  // CHECK: int temporary = Next(i);
  // CHECK-NEXT: i += 1;
  // CHECK-NEXT: i += temporary;
  (i += 1) += Next(i);
  (p.xy += 1) = p.zw + i;
  return p + i + a[0] + a[1];
}
