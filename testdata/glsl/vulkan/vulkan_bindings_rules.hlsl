// Where options put the buffers and objects of a Vulkan shader.
// RUN: %clipc -T vs_5_1 %s --target=vulkan --validate -o - --bindings=dxc | FileCheck %s --check-prefix=DXC
// RUN: %clipc -T vs_5_1 %s --target=vulkan --validate -o - --bindings=nvrhi | FileCheck %s --check-prefix=NVRHI
// RUN: %clipc -T vs_5_1 %s --target=vulkan --validate -o - --bindings=nvrhi -fvk-bind-globals 9 4 -auto-binding-space 2 | FileCheck %s --check-prefix=SETS
// RUN: %clipc -T vs_5_1 %s --target=vulkan --validate -o - -fvk-bind-register t3 1 40 5 | FileCheck %s --check-prefix=ONE
// What has no register gives way to what has.
// DXC: set = 0, binding = 1) uniform Globals
// NVRHI: set = 0, binding = 256) uniform Globals
// SETS: set = 4, binding = 9) uniform Globals
// ONE: set = 0, binding = 0) uniform Globals
float scale;
// DXC: set = 0, binding = 2) uniform A
// NVRHI: set = 0, binding = 258) uniform A
// SETS: set = 0, binding = 258) uniform A
// ONE: set = 0, binding = 2) uniform A
cbuffer A : register(b2) { float4 a; };
// DXC: set = 0, binding = 0) uniform texture2D first;
// NVRHI: set = 0, binding = 0) uniform texture2D first;
// SETS: set = 0, binding = 0) uniform texture2D first;
// ONE: set = 0, binding = 32) uniform texture2D first;
Texture2D first : register(t0);
// DXC: set = 1, binding = 3) uniform texture2D second;
// NVRHI: set = 1, binding = 3) uniform texture2D second;
// SETS: set = 1, binding = 3) uniform texture2D second;
// ONE: set = 5, binding = 40) uniform texture2D second;
Texture2D second : register(t3, space1);
// DXC: set = 0, binding = 3) uniform sampler unplaced;
// NVRHI: set = 0, binding = 128) uniform sampler unplaced;
// SETS: set = 2, binding = 128) uniform sampler unplaced;
// ONE: set = 0, binding = 16) uniform sampler unplaced;
SamplerState unplaced;
float4 main(float4 p : POSITION) : SV_Position {
  return p * scale + a + first.SampleLevel(unplaced, p.xy, 0) + second.SampleLevel(unplaced, p.xy, 0);
}
