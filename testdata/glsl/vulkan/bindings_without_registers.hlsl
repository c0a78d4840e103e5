// A host that combines samplers has a texture and a sampler of one number in one place, also where the text has no registers.
// RUN: %clipc -T ps_6_0 --target=vulkan --bindings=sdl %s -o - | FileCheck %s --check-prefix=SDL
// RUN: %clipc -T ps_6_0 --target=vulkan --auto-sampled-textures %s -o - | FileCheck %s --check-prefix=JOINED
// SDL-DAG: layout(set = 2, binding = 0) uniform texture2D first;
// SDL-DAG: layout(set = 2, binding = 0) uniform sampler linear_sampler;
// SDL-DAG: layout(set = 2, binding = 1) uniform texture2D second;
// SDL-DAG: layout(set = 2, binding = 1) uniform sampler sharp;
// JOINED-DAG: binding = 32) uniform texture2D first;
// JOINED-DAG: binding = 32) uniform sampler linear_sampler;
Texture2D first;
SamplerState linear_sampler;
Texture2D second : register(t1);
SamplerState sharp;

float4 main(float2 uv : T) : SV_Target { return first.Sample(linear_sampler, uv) + second.Sample(sharp, uv); }
