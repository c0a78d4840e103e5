// [[vk::location]] in both halves says where they match when their semantics differ: Vulkan knows no
// semantics, and Direct3D would refuse the pair.
// RUN: %clipc -T vs_5_0 %s --target=vulkan --validate -o - --pixel-shader=%s --pixel-entry=ps | FileCheck %s
struct Varyings {
  float4 position : SV_Position;
  [[vk::location(1)]] float2 uv : TEXCOORD3;
  [[vk::location(0)]] float4 color : COLOR;
};
// CHECK: layout(location = 0) out vec4 {{.*}} // color : COLOR0
// CHECK: layout(location = 1) out vec2 {{.*}} // uv : TEXCOORD3
Varyings main(float4 p : POSITION) {
  Varyings result = {p, p.xy, p.zwxy};
  return result;
}
struct Read {
  [[vk::location(0)]] float4 color : COLOR;
  [[vk::location(1)]] float2 uv : TEXCOORD0;
};
float4 ps(Read input) : SV_Target { return input.color * input.uv.x; }
