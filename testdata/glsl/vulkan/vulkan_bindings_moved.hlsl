// What has neither a binding nor a register gives way to what has.
// RUN: %clipc -T vs_5_1 %s --target=vulkan --validate -o - | FileCheck %s
// CHECK: layout(std140, set = 0, binding = 2) uniform Globals {  // b0
float scale;
// CHECK: layout(std140, set = 0, binding = 1) uniform A {  // b1
cbuffer A : register(b1) { float4 a; };
// CHECK: layout(std140, set = 0, binding = 0) uniform B {  // b2
[[vk::binding(0)]] cbuffer B { float4 b; };
// CHECK: layout(set = 0, binding = 33) uniform texture2D moved;  // t0
Texture2D moved;
// CHECK: layout(set = 0, binding = 32) uniform texture2D given;  // t1
[[vk::binding(32)]] Texture2D given;
float4 main(float4 p : POSITION) : SV_Position {
  return p * scale + a + b + moved.Load(int3(0, 0, 0)) + given.Load(int3(0, 0, 0));
}
