// Registers of all kinds share a set's bindings: b at 0, s at 16, t at 32; the space is the set.
// RUN: %clipc -T vs_5_1 --target=vulkan --validate %s -o - | FileCheck %s
// AUTOUPDATE
cbuffer Scene : register(b3, space1) { float4x4 view; }
Texture2D heights : register(t2);
SamplerState linear_clamp : register(s1);
StructuredBuffer<float4> points : register(t3);

float4 main(float4 p : POSITION, uint i : INDEX) : SV_Position {
  p.y += heights.SampleLevel(linear_clamp, p.xz, 0).x;
  return mul(p + points[i], view);
}

// CHECK: #version 460
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, set = 1, binding = 3) uniform Scene {  // b3, space1
// CHECK-NEXT:     layout(row_major) mat4 view;
// CHECK-NEXT: } scene;
// CHECK-EMPTY:
// CHECK-NEXT: layout(set = 0, binding = 34) uniform texture2D heights;  // t2
// CHECK-NEXT: layout(set = 0, binding = 17) uniform sampler linear_clamp;  // s1
// CHECK-NEXT: layout(std430, set = 0, binding = 35) readonly buffer points_block {  // t3
// CHECK-NEXT:     vec4 points[];
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-NEXT: layout(location = 1) in uint in_INDEX0;  // i : INDEX0
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     vec4 p = in_POSITION0;
// CHECK-NEXT:     p.y += textureLod(sampler2D(heights, linear_clamp), p.xz, 0.0).x;
// CHECK-NEXT:     gl_Position = scene.view * (p + points[in_INDEX0]);
// CHECK-NEXT: }
