// Debug information: the HLSL, and the line of each instruction, by the core of SPIR-V or by a set for debuggers; what -fspv-debug chooses.
// RUN: %clipc -T vs_6_0 -spirv -Zi -S %s -o - | FileCheck %s
// RUN: %clipc -T vs_6_0 -spirv -Zi %s -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %clipc -T vs_6_0 -spirv -fspv-debug=file -S %s -o - | FileCheck %s --check-prefix=NAME
// RUN: %clipc -T vs_6_0 -spirv -fspv-debug=tool -S %s -o - | FileCheck %s --check-prefix=TOOL
// RUN: %clipc -T vs_6_0 -spirv -fspv-debug=vulkan-with-source -S %s -o - | FileCheck %s --check-prefix=SET
// RUN: %clipc -T vs_6_0 -spirv -fspv-debug=vulkan-with-source %s -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %clipc -T vs_6_0 -spirv -fspv-debug=vulkan -fspv-target-env=vulkan1.3 %s -o %t.spv && spirv-val --target-env vulkan1.3 %t.spv
// CHECK:      [[FILE:%[0-9]+]] = OpString "lines.hlsl"
// CHECK-NEXT: OpSource HLSL 600 [[FILE]] "// Debug information
// CHECK:      OpLine [[FILE]] 36 8
// CHECK-NEXT: OpFunction %void
// CHECK:      OpLine [[FILE]] 38
// CHECK-NEXT: OpLoad
// CHECK:      OpLine [[FILE]] 40
// CHECK:      OpLine [[FILE]] 41
// CHECK-NOT:  OpModuleProcessed
// NAME:     OpSource HLSL 600 {{%[0-9]+}}
// NAME-NOT: OpLine
// TOOL:     OpModuleProcessed "clipc {{[0-9.]+}}
// TOOL:     OpLine
// SET:      OpExtension "SPV_KHR_non_semantic_info"
// SET:      [[DEBUG:%[0-9]+]] = OpExtInstImport "NonSemantic.Shader.DebugInfo.100"
// SET:      [[FILE:%[0-9]+]] = OpString "lines.hlsl"
// SET:      [[TEXT:%[0-9]+]] = OpString "// Debug information
// SET:      [[SOURCE:%[0-9]+]] = OpExtInst %void [[DEBUG]] DebugSource [[FILE]] [[TEXT]]
// SET:      [[UNIT:%[0-9]+]] = OpExtInst %void [[DEBUG]] DebugCompilationUnit %uint_1 %uint_4 [[SOURCE]] %uint_5
// SET:      [[MAIN:%[0-9]+]] = OpExtInst %void [[DEBUG]] DebugFunction {{.*}} [[SOURCE]] %uint_36 %uint_8 [[UNIT]]
// SET:      OpExtInst %void [[DEBUG]] DebugFunctionDefinition [[MAIN]] %main
// SET:      OpExtInst %void [[DEBUG]] DebugScope [[MAIN]]
// SET-NEXT: OpExtInst %void [[DEBUG]] DebugLine [[SOURCE]] %uint_38 %uint_38
// SET-NOT:  OpLine
float4 light;

// A line before the function.
float4 main(float4 p : POSITION, int n : N)
    : SV_Position {
  float4 sum = p * light;
  if (n > 2)
    sum += light +
           p.wzyx * 2;
  return sum;
}
