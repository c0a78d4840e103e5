// A pipeline of Vulkan may give a group another size: GLSL has the number of the constant in the layout, SPIR-V a WorkgroupSize.
// RUN: %clipc %s -T cs_6_0 --target=vulkan --validate -Werror -o - | FileCheck %s
// RUN: %clipc %s -T cs_6_0 -spirv -o %t.spv && spirv-dis %t.spv | FileCheck %s --check-prefix=SPIRV
// RUN: %clipc %s -T cs_6_0 -o - 2>&1 | FileCheck %s --check-prefix=OPENGL
// RUN: %clipc %s -T cs_6_0 --target=vulkan -E computed -o %t.comp 2>&1 | FileCheck %s --check-prefix=COMPUTED
// CHECK: layout(local_size_x = 64, local_size_y = 2, local_size_z = 1, local_size_x_id = 3, local_size_z_id = 4) in;
// SPIRV: OpDecorate %{{[0-9]+}} SpecId 3
// SPIRV: OpDecorate %{{[0-9]+}} SpecId 4
// SPIRV: OpDecorate %gl_WorkGroupSize BuiltIn WorkgroupSize
// SPIRV: %gl_WorkGroupSize = OpSpecConstantComposite
// OPENGL: warning: `threads` keeps its value under target `glsl450`
// OPENGL: layout(local_size_x = 64, local_size_y = 2, local_size_z = 1) in;
[[vk::constant_id(3)]] const uint threads = 64;
[[vk::constant_id(4)]] const int layers = 1;
RWStructuredBuffer<uint> to;
[numthreads(threads, 2, layers)] void main(uint i : SV_GroupIndex) { to[i] = i; }
// COMPUTED: [[#@LINE+1]]:13: warning: `numthreads` computes with `threads`, which a pipeline may give another value; the group keeps the size of the value in the text; name the constant alone [-Wgroup-size-computed]
[numthreads(threads / 2, 1, 1)] void computed(uint i : SV_GroupIndex) { to[i] = i; }
