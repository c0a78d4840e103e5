// RUN: not %clipc -T vs_6_6 %s 2>&1 | FileCheck %s
// The dynamic resources of shader model 6.6 (HLSL specification, "Dynamic resource binding"): GLSL cannot say them.
float4 main(uint i : I) : SV_Position {
  // CHECK: [[#@LINE+1]]:32: error: `ResourceDescriptorHeap` is not supported; GLSL has no objects without a declaration; declare an array of them with a register [descriptor-heap]
  StructuredBuffer<float4> b = ResourceDescriptorHeap[3];
  // CHECK: [[#@LINE+1]]:20: error: `SamplerDescriptorHeap` is not supported
  SamplerState s = SamplerDescriptorHeap[i];
  return b[i];
}
