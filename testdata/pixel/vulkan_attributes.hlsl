// A pixel shader with attributes of Vulkan: its built-in inputs meet nothing, and its push constants
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
float4 ps(Varyings input) : SV_Target { return input.color * input.uv.x + pushed.index; }
