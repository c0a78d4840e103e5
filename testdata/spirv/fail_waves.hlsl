// What SPIR-V lacks: waves before 1.3, the number of samples of the target. Oracle for waves: dxc refuses them for Vulkan 1.0.
// RUN: not %clipc -T ps_6_0 -spirv -fspv-target-env=vulkan1.0 %s -o %t.spv 2>&1 | FileCheck %s
// RUN: not %clipc -T ps_6_0 -G %s -o %t.spv 2>&1 | FileCheck %s --check-prefix=OPENGL
// RUN: not %clipc -T ps_6_0 -E samples -G %s -o %t.spv 2>&1 | FileCheck %s --check-prefix=SAMPLES
float4 main(float4 a : A) : SV_Target {
  // CHECK: [[#@LINE+4]]:10: error: `WaveActiveSum` is not in SPIR-V 1.0 for Vulkan [not-in-spirv]
  // CHECK: note: `-fspv-target-env=vulkan1.1` has it
  // CHECK: [[#@LINE+2]]:29: error: `WaveGetLaneIndex` is not in SPIR-V 1.0 for Vulkan [not-in-spirv]
  // OPENGL: [[#@LINE+1]]:10: error: `WaveActiveSum` is not in SPIR-V 1.0 for OpenGL [not-in-spirv]
  return WaveActiveSum(a) + WaveGetLaneIndex();
}
// OPENGL: note: target `vulkan` can
// SAMPLES: error: `GetRenderTargetSampleCount` is not in SPIR-V 1.0 for OpenGL [not-in-spirv]
float4 samples() : SV_Target { return GetRenderTargetSampleCount(); }
