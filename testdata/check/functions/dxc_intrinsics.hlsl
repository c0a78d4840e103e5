// DXC looks for a function of the shader's only where no intrinsic of its name takes the arguments; fxc calls the shader's: vkd3d's
// intrinsic-override.shader_test, checked against both.
// RUN: %clipc -T vs_6_0 %s --validate -o - 2>%t.messages | FileCheck %s --check-prefix=DXC
// RUN: FileCheck %s --check-prefix=MESSAGE --input-file=%t.messages
// RUN: %clipc -T vs_5_0 %s --validate -o - | FileCheck %s --check-prefix=FXC
// RUN: %draw compare %s -T vs_6_0
struct Vertex { float4 p; };
float2 max(float2 a, float2 b) { return a + b; }
// No intrinsic takes a struct.
float4 abs(Vertex v) { return v.p * 2; }
namespace own { float4 saturate(float4 v) { return v * 3; } }
float4 main(Vertex v : P) : SV_Position {
  // MESSAGE: [[#@LINE+3]]:20: warning: `max` is the intrinsic and not the function of this name, {{.*}} [-Wintrinsic-before-function]
  // DXC: vec2 m = max(v.p.xy, v.p.zw);
  // FXC: vec2 m = max_(v.p.xy, v.p.zw);
  const float2 m = max(v.p.xy, v.p.zw);
  return abs(v) + own::saturate(v.p) + m.xyxy;
}
