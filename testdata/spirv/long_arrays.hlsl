// Arrays of more than 1,024 elements that are copied whole, out of constant buffers and structured buffers and into these, by loops.
// RUN: %clipc -T vs_5_0 -spirv -S %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 -spirv %s -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %clipc -T vs_5_0 -spirv -fspv-target-env=vulkan1.0 %s -o %t.spv && spirv-val --target-env vulkan1.0 %t.spv
// RUN: %clipc -T vs_5_0 -G %s -o %t.spv && spirv-val --target-env opengl4.5 %t.spv
// RUN: %clipc -T ps_5_0 -E stored -spirv -S %s -o - | FileCheck %s --check-prefix=STORED
// RUN: %clipc -T ps_5_0 -E stored -spirv %s -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// CHECK: OpSource HLSL 500
// CHECK: OpPhi
// CHECK: OpLoopMerge
struct Part {
  float3 points[1040];
  bool is_on;
};
cbuffer Frame : register(b0) {
  float4 colors[1100];
  float weights[12][100];
};
cbuffer Parts : register(b1) { Part part; };
float Sum(float4 c[1100], float w[12][100], Part p, uint i) {
  c[1] = 3;
  w[11][99] += 1;
  return c[i].y + w[i % 12][i % 100] + p.points[i].z + (p.is_on ? 1 : 2);
}
float4 main(uint i : I) : SV_Position { return Sum(colors, weights, part, i); }

struct Kept {
  float values[1500];
  bool is_on;
};
cbuffer Other : register(b2) { Kept kept; };
RWStructuredBuffer<Kept> all : register(u1);
// STORED: OpLoopMerge
// STORED: OpLoopMerge
// STORED: OpLoopMerge
float4 stored(nointerpolation uint i : I) : SV_Target {
  Kept part = kept;
  part.values[i] = 2;
  all[i] = part;
  Kept other = all[i];
  other.values[i + 1] += 1;
  return other.values[i] + other.values[i + 1] + other.is_on;
}
