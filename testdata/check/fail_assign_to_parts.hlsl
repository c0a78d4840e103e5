// What is not made of the components of variables is not assigned to: fxc X3025.
// RUN: not %clipc -T vs_5_0 %s -o %t 2>&1 | FileCheck %s
// AUTOUPDATE
float4 main(float4 p : POSITION) : SV_Position {
  float2 a, b;
// CHECK: fail_assign_to_parts.hlsl:[[#@LINE+3]]:3: error: this cannot be assigned to; a variable, a member or components of one can [not-assignable, X3025]
// CHECK-NEXT:     [[#@LINE+2]] |   float4(a, 1, 2) = p;
// CHECK-NEXT:       |   ^~~~~~~~~~~~~~~
  float4(a, 1, 2) = p;
// CHECK-NEXT: fail_assign_to_parts.hlsl:[[#@LINE+3]]:3: error: this cannot be assigned to; a variable, a member or components of one can [not-assignable, X3025]
// CHECK-NEXT:    [[#@LINE+2]] |   float4(a, b) += p;
// CHECK-NEXT:       |   ^~~~~~~~~~~~
  float4(a, b) += p;
  const float2 c = a;
// CHECK-NEXT: fail_assign_to_parts.hlsl:[[#@LINE+6]]:13: error: `c` is constant; it cannot be assigned to [const-assigned, X3025]
// CHECK-NEXT:    [[#@LINE+5]] |   float4(a, c) = p;
// CHECK-NEXT:       |             ^
// CHECK-NEXT: fail_assign_to_parts.hlsl:[[#@LINE-4]]:16: note: `c` is declared here
// CHECK-NEXT:    [[#@LINE-5]] |   const float2 c = a;
// CHECK-NEXT:       |                ^
  float4(a, c) = p;
  return p;
}
