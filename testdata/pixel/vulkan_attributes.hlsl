// A pixel shader with attributes of Vulkan: its built-in inputs match nothing, and its push constants
// may lie where Direct3D would not put them.
// RUN: %clipc -T vs_5_0 %s --target=vulkan --validate -o - --pixel-shader=%s --pixel-entry=ps | FileCheck %s
struct Varyings {
  float4 position : SV_Position;
  [[vk::location(1)]] float2 uv : TEXCOORD0;
  [[vk::builtin("PointSize")]] float size : PSIZE;
  [[vk::location(0)]] float4 color : COLOR;
};
// CHECK: layout(location = 0) out vec4
// CHECK: layout(location = 1) out vec2
// CHECK: gl_PointSize = 4.0;
Varyings main(float4 p : POSITION) {
  Varyings result;
  result.position = p;
  result.uv = p.xy;
  result.size = 4;
  result.color = p.zwxy;
  return result;
}
struct Pushed { [[vk::offset(4)]] uint index; };
[[vk::push_constant]] Pushed pushed;
// A pixel shader's outputs, of which only some have a location, are not looked at.
struct Targets {
  [[vk::location(0)]] float4 color : SV_Target0;
  float depth : SV_Depth;
};
Targets ps(Varyings input) {
  Targets result;
  result.color = input.color * input.uv.x + pushed.index;
  result.depth = 0;
  return result;
}
