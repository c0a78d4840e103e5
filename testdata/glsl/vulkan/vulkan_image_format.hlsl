// [[vk::image_format]] in GLSL's spelling.
// RUN: %clipc -T vs_5_0 %s --target=vulkan --validate -o - | FileCheck %s
// CHECK: layout(set = 0, binding = 160, rgba8_snorm) uniform image2D a;
[[vk::image_format("rgba8snorm")]] RWTexture2D<float4> a;
// CHECK: layout(set = 0, binding = 161, r11f_g11f_b10f) uniform image2D b;
[[vk::image_format("r11g11b10f")]] RWTexture2D<float3> b;
// CHECK: layout(set = 0, binding = 162, r8ui) uniform uimageBuffer c;
[[vk::image_format("r8ui")]] RWBuffer<uint> c;
float4 main(float4 p : POSITION) : SV_Position { return p + a[uint2(0, 1)] + b[uint2(1, 2)].xyzz + c[3]; }
