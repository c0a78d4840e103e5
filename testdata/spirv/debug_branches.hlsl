// The debugger's instructions stand after the OpPhi of a block: SPIR-V lets nothing but OpLine and OpNoLine stand before it.
// RUN: %clipc -T ps_6_0 -spirv -fspv-debug=vulkan %s -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %clipc -T ps_6_0 -spirv -fspv-debug=vulkan-with-source %s -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %clipc -T ps_6_0 -spirv -Zi %s -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %clipc -T ps_6_0 -spirv -fspv-debug=vulkan -S %s -o - | FileCheck %s
cbuffer C { float k; };
float Doubled(float x) { return x * 2; }

// CHECK:      OpPhi %bool
// CHECK-NEXT: OpExtInst %void {{%[0-9]+}} DebugScope
float4 main(float4 p : P) : SV_Target {
  float4 q = p.w > k ? Doubled(p.x) : 1;
  if (p.x > k && Doubled(p.y) > 2)
    q = 2;
  return q;
}
