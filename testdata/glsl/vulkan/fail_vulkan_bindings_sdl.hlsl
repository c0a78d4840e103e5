// Only one texture and one sampler share a binding under SDL's rules.
// RUN: not %clipc -T vs_5_1 --target=vulkan --bindings=sdl %s 2>&1 | FileCheck %s
Texture2D height : register(t0, space0);
SamplerState height_sampler : register(s0, space0);
// CHECK: [[#@LINE+1]]:48: error: `height` and `offsets` both become binding 0 of set 0; {{.*}} [target-bindings-collide]
[[vk::binding(0, 0)]] StructuredBuffer<float4> offsets : register(t5);
float4 main(float4 position : POSITION) : SV_Position {
  return position + offsets[0] + height.SampleLevel(height_sampler, position.xz, 0).x;
}
