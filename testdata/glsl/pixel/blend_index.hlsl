// Two colors of one render target, which the blender combines: "Vulkan specific attributes", vk::index, in DXC's SPIR-V.rst. In Direct3D they
// are SV_Target0 and SV_Target1, and the blend state alone says so.
// RUN: %clipc %s -T ps_5_0 -E ps --validate --reflect=%t.json -o - | FileCheck %s
// RUN: FileCheck %s --check-prefix=JSON --input-file=%t.json
// RUN: %clipc %s -T ps_5_0 -E ps --target=vulkan --validate -o - | FileCheck %s
// RUN: %clipc %s -T ps_5_0 -E ps --target=glsl330 --validate -o - | FileCheck %s
// RUN: %clipc %s -T ps_5_0 -E ps --target=essl300 --validate -o - | FileCheck %s --check-prefixes=CHECK,ES
// RUN: %clipc %s -T ps_5_0 -E parameter --validate -o - | FileCheck %s --check-prefix=PARAMETER
// RUN: %clipc %s -T vs_5_0 -E vs -fsyntax-only 2>&1 | FileCheck %s --check-prefix=VERTEX
struct Colors {
  [[vk::location(0), vk::index(0)]] float4 color : SV_Target0;
  [[vk::location(0), vk::index(1)]] float4 factor : SV_Target1;
};
// ES: #extension GL_EXT_blend_func_extended : require
// CHECK: layout(location = 0) out vec4 SV_Target0;  // color : SV_Target0
// CHECK-NEXT: layout(location = 0, index = 1) out vec4 SV_Target1;  // factor : SV_Target1
// JSON: "blendIndex": 1
Colors ps(float4 c : COLOR) {
  Colors o;
  o.color = c;
  o.factor = 1 - c;
  return o;
}

// PARAMETER: layout(location = 0, index = 1) out vec4 SV_Target1;
void parameter(out float4 a : SV_Target0, [[vk::location(0), vk::index(1)]] out float4 b : SV_Target1) {
  a = 1;
  b = 0.5;
}

// VERTEX: [[#@LINE+1]]:81: warning: attribute `vk::index` has no effect
float4 vs(float4 p : POSITION, [[vk::location(0), vk::index(1)]] out float4 c : COLOR) : SV_Position { return c = p; }
