// Places that [[vk::...]] gives, in Vulkan and where OpenGL can say them.
// RUN: %clipc -T vs_5_0 %s --target=vulkan --validate -o - | FileCheck %s --check-prefixes=CHECK,VULKAN
// RUN: %clipc -T vs_5_0 %s --target=glsl450 --validate -o - -Wno-target-constant-id | FileCheck %s --check-prefixes=CHECK,OPENGL
// RUN: %clipc -T vs_5_0 %s --target=glsl450 -o /dev/null 2>&1 | FileCheck %s --check-prefix=WARNING
// RUN: %clipc -T vs_5_0 %s --target=vulkan -o /dev/null --reflect=- | FileCheck %s --check-prefix=JSON
// RUN: %clipc -T vs_5_0 %s --target=vulkan -o %t.spv && spirv-val %t.spv
// RUN: %draw compare %s -T vs_5_0 --target vulkan,glsl450 | FileCheck %s --check-prefix=VALUES
// VALUES: : 0 wrong,

// VULKAN: layout(std140, push_constant) uniform push_block {
// OPENGL: layout(std140, binding = 0) uniform push_block {
// CHECK-NEXT: mat4 world;
// CHECK-NEXT: vec4 plane;
// CHECK-NEXT: vec2 offset;
// CHECK-NEXT: float scale;
// CHECK-NEXT: uint index;
// CHECK-NEXT: } push;
struct Push {
  float4x4 world;
  float4 plane;
  [[vk::offset(80)]] float2 offset;
  float scale;
  uint index;
};
// JSON: "name": "push"
// JSON: "pushConstant": true
[[vk::push_constant]] Push push;

// VULKAN: layout(std140, set = 2, binding = 4) uniform Camera {  // b1
// OPENGL: layout(std140, binding = 4) uniform Camera {  // b1
[[vk::binding(2 + 2, 2)]] cbuffer Camera : register(b1) { float4x4 view; };

// An object without a binding of its own does not take that of another.
// VULKAN: layout(set = 0, binding = 37) uniform texture2D other;  // t5
// OPENGL: layout(binding = 0) uniform sampler2D other;
// VULKAN: layout(set = 0, binding = 5) uniform texture2D map;  // t0
// OPENGL: layout(binding = 5) uniform sampler2D map;
// VULKAN: layout(set = 1, binding = 7) uniform sampler smooth_;  // s0
Texture2D<float4> other : register(t5);
[[vk::binding(5)]] Texture2D<float4> map : register(t0);
[[vk::binding(7, 1)]] SamplerState smooth;

// Elements of an array have one location after another.
// CHECK: layout(location = 1) in vec2 in_TEXCOORD0;
// CHECK: layout(location = 2) in vec2 in_TEXCOORD1;
// CHECK: layout(location = 3) in vec3 in_POSITION0;
struct Input {
  [[vk::location(3)]] float3 position : POSITION;
  [[vk::location(1)]] float2 uv[2] : TEXCOORD0;
  [[vk::builtin("BaseInstance")]] uint base : A;
};
// CHECK: layout(location = 0) out vec4 vs_COLOR0;
// CHECK: layout(location = 2) out vec2 vs_TEXCOORD0;
struct Output {
  float4 position : SV_Position;
  [[vk::location(2)]] float2 uv : TEXCOORD0;
  [[vk::location(0)]] float4 color : COLOR;
  [[vk::builtin("PointSize")]] float size : PSIZE;
};

// VULKAN: layout(constant_id = 3) const int kCount = 4;
// OPENGL: int kCount = 4;
// WARNING: warning: `kCount` keeps its value under target `glsl450`; only Vulkan gives a `vk::constant_id` another one when it makes a pipeline [-Wtarget-constant-id]
[[vk::constant_id(3)]] const int kCount = 4;

// CHECK: uint(gl_BaseInstance
// CHECK: gl_PointSize = 2.0;
// CHECK: gl_ClipDistance[0] = dot(
[clipplanes(push.plane)]
Output main(Input input) {
  Output output;
  output.position = mul(mul(float4(input.position, 1), push.world), view) * push.scale;
  output.position += other.SampleLevel(smooth, push.offset, 0) + map.SampleLevel(smooth, input.uv[0], 0);
  output.uv = input.uv[1] * kCount;
  output.color = input.base + push.index;
  output.size = 2;
  return output;
}
