// -fspv-preserve-bindings: objects and constant buffers that nothing reads are in the module, with their bindings, and in the reflection.
// RUN: %clipc -T ps_6_0 -spirv -fspv-preserve-bindings -S %s -o - | FileCheck %s
// RUN: %clipc -T ps_6_0 -spirv -fspv-preserve-bindings %s -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %clipc -T ps_6_0 -spirv -fspv-preserve-bindings -fspv-target-env=vulkan1.3 %s -o %t.spv && spirv-val --target-env vulkan1.3 %t.spv
// RUN: %clipc -T ps_6_0 -spirv -fpreserve-bindings -fspv-target-env=vulkan1.0 %s -o %t.spv && spirv-val --target-env vulkan1.0 %t.spv
// RUN: %clipc -T ps_6_0 --target=vulkan -fspv-preserve-bindings %s -o - 2>&1 | FileCheck %s --check-prefix=GLSL
// RUN: %clipc -T ps_6_0 -spirv -fspv-preserve-bindings --reflect=%t.json %s -o %t.spv && FileCheck %s --check-prefix=FACTS --input-file=%t.json
// RUN: %clipc -T ps_6_0 -spirv -S %s -o - | FileCheck %s --check-prefix=PLAIN
// RUN: %clipc -T ps_6_0 -G -fspv-preserve-bindings %s -o %t.spv 2>&1 | FileCheck %s --check-prefix=OPENGL
// CHECK-DAG: OpDecorate %Unread_0 Binding
// CHECK-DAG: OpDecorate %unread_map DescriptorSet 2
// CHECK-DAG: OpDecorate %unread_map Binding
// CHECK-DAG: OpDecorate %unread_sampler Binding
// CHECK-DAG: OpDecorate %points Binding
// CHECK-DAG: OpDecorate %image Binding
// CHECK-DAG: OpDecorate %maps Binding
// CHECK-DAG: OpDecorate %settings Binding
// GLSL: `-fspv-preserve-bindings` has no effect: it is for SPIR-V
// GLSL-NOT: unread_map
// FACTS-DAG: "unread_map"
// FACTS-DAG: "Unread"
// PLAIN: OpMemoryModel
// PLAIN-NOT: {{unread|Unread|points|maps|settings}}
// OPENGL: `-fspv-preserve-bindings` has no effect: it is for target `vulkan`
Texture2D map : register(t0);
SamplerState linear_wrap : register(s0);
Texture2D unread_map : register(t3, space2);
SamplerState unread_sampler : register(s4);
Texture2D<float4> maps[3] : register(t5);
struct Point {
  float3 place;
  uint count;
};
StructuredBuffer<Point> points : register(t9);
RWTexture2D<float4> image : register(u3);
struct Settings {
  float2 scale;
};
ConstantBuffer<Settings> settings : register(b6);
cbuffer Frame : register(b0) { float4 color; };
cbuffer Unread : register(b5) {
  float4 a;
  row_major float4x4 b;
};
float4 main(float2 uv : UV) : SV_Target { return map.Sample(linear_wrap, uv) * color; }
