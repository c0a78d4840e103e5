// Subpass inputs (DXC's SPIR-V.rst, "Subpass inputs"): Vulkan's own, and textures elsewhere.
// RUN: %clipc -T ps_5_0 --target=vulkan --validate --verify %s -o - | FileCheck %s --check-prefix=VULKAN
// RUN: %clipc -T ps_5_0 --validate --verify %s -o - | FileCheck %s
// RUN: %clipc -T ps_5_0 -DUPPER --validate --verify %s -o - | FileCheck %s --check-prefix=UPPER
// RUN: %clipc -T ps_5_0 --target=essl310 --validate --verify %s -o - | FileCheck %s --check-prefix=ES
// RUN: %clipc -T ps_5_0 -G -S %s -o - | FileCheck %s --check-prefix=MODULE
// RUN: %clipc -T ps_5_0 -G %s -o %t.spv && spirv-val --target-env opengl4.5 %t.spv
// RUN: %clipc -T ps_5_0 -G --flip-y %s -o %t.spv && spirv-val --target-env opengl4.5 %t.spv
// MODULE: OpImageQuerySizeLod
// MODULE: OpConvertFToS %v2int
// MODULE: OpImageFetch %v4float {{.*}} Lod
// MODULE: OpImageFetch %v4uint {{.*}} Sample
[[vk::input_attachment_index(2), vk::binding(4, 1)]] SubpassInput<float2> normals;
[[vk::input_attachment_index(0)]] SubpassInputMS<uint4> ids : register(t3);
[[vk::input_attachment_index(1)]] SubpassInput colors;
float4 main(float4 p : SV_Position) : SV_Target {
#ifdef UPPER
  return colors.SubpassLoad() * p.y;
#else
  return float4(normals.SubpassLoad(), ids.SubpassLoad(3).x, 0) + colors.SubpassLoad();
#endif
}
// VULKAN-DAG: layout(input_attachment_index = 2, set = 1, binding = 4) uniform subpassInput normals;
// VULKAN-DAG: layout(input_attachment_index = 0, set = 0, binding = 291) uniform usubpassInputMS ids;
// VULKAN-DAG: layout(input_attachment_index = 1, set = 0, binding = {{[0-9]+}}) uniform subpassInput colors;
// VULKAN: subpassLoad(normals).xy, float(subpassLoad(ids, 3).x)
// VULKAN: subpassLoad(colors)
// CHECK-DAG: uniform sampler2D normals;
// CHECK-DAG: uniform usampler2DMS ids;
// CHECK: texelFetch(normals, ivec2(gl_FragCoord.xy), 0).xy, float(texelFetch(ids, ivec2(gl_FragCoord.xy), 3).x)
// CHECK: texelFetch(colors, ivec2(gl_FragCoord.xy), 0)
// UPPER: texelFetch(colors, ivec2(gl_FragCoord.x, float(textureSize(colors, 0).y) - gl_FragCoord.y), 0) * gl_FragCoord.y
// ES: texelFetch(normals, ivec2(gl_FragCoord.xy), 0).xy
