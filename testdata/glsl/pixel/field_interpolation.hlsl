// Words of interpolation on a struct's field and on the parameter: up to 5.1 `nointerpolation` of either counts, from 6.0 on the
// field's words alone where it has some. Oracle: vkd3d's nointerpolation.shader_test, checked against fxc and dxc.
// RUN: %clipc -T ps_5_0 %s -o - | FileCheck --check-prefix=FXC %s
// RUN: %clipc -T ps_6_0 %s -o - | FileCheck --check-prefix=DXC %s
struct Input {
  centroid float4 own : OWN;
  float4 none : NONE;
};

// FXC: layout(location = 0) flat in vec4 vs_OWN0;
// FXC: layout(location = 1) flat in vec4 vs_NONE0;
// DXC: layout(location = 0) centroid in vec4 vs_OWN0;
// DXC: layout(location = 1) flat in vec4 vs_NONE0;
float4 main(nointerpolation Input input) : SV_Target { return input.own + input.none; }
