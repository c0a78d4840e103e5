// A sampler that Direct3D 9's functions read and methods sample with: the texture of the former is a resource of its own, whose register is
// before those of the textures from shader model 4 on: vkd3d's combined-samplers.shader_test, checked against native.
// RUN: %clipc -T ps_4_0 %s --validate -o - | FileCheck %s
// RUN: %clipc -T ps_4_0 %s --target=vulkan --validate -o - | FileCheck %s --check-prefix=VULKAN
// RUN: %clipc -T ps_3_0 %s --validate -o - | FileCheck %s --check-prefix=OLD
// RUN: %draw compare %s -T ps_4_0 --target glsl450,glsl330
// RUN: %draw compare %s -T ps_3_0 --target glsl450,glsl120
// CHECK: uniform sampler2D both;  // t0
// VULKAN-DAG: uniform sampler2D both;  // t0
// VULKAN-DAG: uniform texture2D colors;  // t3
// OLD: uniform sampler2D both_2;  // both : t1
Texture2D colors;
sampler both;
sampler pairs[2];
float4 main(float2 uv : TEXCOORD0) : SV_Target {
  // CHECK: texture(colors, vs_TEXCOORD0)
  return 10 * colors.Sample(both, uv) + tex2D(both, uv) + tex2D(pairs[0], uv) + tex1D(pairs[1], uv.x);
}
