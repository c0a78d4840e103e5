// A texture or sampler without a semantic is the shader's, as if it were uniform, in fxc's 5.0 and 5.1: vkd3d's object-parameters.shader_test,
// line 129, checked against native. In DXC it is not.
// RUN: %clipc -T ps_5_0 %s --validate -o - | FileCheck %s
// RUN: %draw compare %s -T ps_5_0
// CHECK: uniform sampler2D color;  // t0 with s : s0
float4 main(Texture2D color, SamplerState s, float2 uv : UV) : SV_Target { return color.Sample(s, uv); }
