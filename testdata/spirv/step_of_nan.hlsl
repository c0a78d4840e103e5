// step(edge, x) is (x >= edge) ? 1 : 0 in the HLSL reference, and so 0 where one of both is NaN; Step of SPIR-V would be 1.
// RUN: %clipc -T ps_5_0 -spirv -S %s -o - | FileCheck %s
// RUN: %clipc -T ps_5_0 -spirv %s -o %t.spv && spirv-val %t.spv
// CHECK-NOT: Step
// CHECK: [[REACHED:%[0-9]+]] = OpFOrdGreaterThanEqual %v4bool
// CHECK: OpSelect %v4float [[REACHED]]
float4 main(float4 edge : EDGE, float4 x : X) : SV_Target { return step(edge, x); }
