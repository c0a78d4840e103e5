// Textures and samplers in a struct that is a parameter of the entry point are those of the shader, as if the parameter were uniform:
// fxc takes them in 5.0 and 5.1 (a test of vkd3d's, checked against native), and not before; dxc refuses them ("not allowed in entry
// function parameters").
// RUN: %clipc -T vs_5_0 --target=glsl450 --validate %s -o - | FileCheck %s
struct Material {
  float4 position : POSITION;
  Texture2D colors[2];
  SamplerState smooth;
  float4x4 frame : FRAME;
};
float4 Look(Material m) { return mul(m.frame, m.colors[1].SampleLevel(m.smooth, m.position.xy, 0)); }
// CHECK: uniform sampler2D first_colors[2];
float4 main(Material first) : SV_Position {
  Material moved = first;
  moved.position *= 2;
  // CHECK: textureLod(first_colors[1], m.position.xy, 0.0)
  return Look(moved) + first.colors[0].SampleLevel(first.smooth, first.position.zw, 0);
}
// RUN: %draw compare %s -T vs_5_0
