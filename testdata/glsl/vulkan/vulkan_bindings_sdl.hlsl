// SDL's GPU API: in set 0 textures, each with the sampler of its number in one combined image
// sampler, then storage buffers; in set 1 uniform buffers.
// RUN: %clipc -T vs_5_1 --target=vulkan --bindings=sdl --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_1 --target=vulkan --bindings=sdl %s -o %t.spv
// CHECK-DAG: layout(std140, set = 1, binding = 0) uniform Frame {
// CHECK-DAG: layout(set = 0, binding = 0) uniform texture2D height;
// CHECK-DAG: layout(set = 0, binding = 0) uniform sampler height_sampler;
// CHECK-DAG: layout(set = 0, binding = 1) uniform texture2D noise;
// CHECK-DAG: layout(set = 0, binding = 1) uniform sampler noise_sampler;
// CHECK-DAG: layout({{.*}}set = 0, binding = 2) readonly buffer
cbuffer Frame : register(b0, space1) { float4x4 view; };
Texture2D height : register(t0, space0);
SamplerState height_sampler : register(s0, space0);
Texture2D noise : register(t1, space0);
SamplerState noise_sampler : register(s1, space0);
StructuredBuffer<float4> offsets : register(t2, space0);
float4 main(float4 position : POSITION) : SV_Position {
  position.y += height.SampleLevel(height_sampler, position.xz, 0).x;
  position.y += noise.SampleLevel(noise_sampler, position.xz, 0).x;
  return mul(view, position + offsets[0]);
}
