// SV_VertexID of a shader that reads no attributes and no textures or buffers is gl_VertexID: no vertices lie in memory from which a base
// vertex would leave some out. The reflection says that the base is taken for 0. Vulkan's number includes the first vertex of every draw.
// RUN: %clipc -T vs_5_0 %s --validate -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 %s --target=glsl330 --validate -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 %s -o %t --reflect=- | FileCheck %s --check-prefix=REFLECT
// RUN: %clipc -T vs_5_0 %s -D ATTRIBUTE --validate -o - | FileCheck %s --check-prefix=EXACT
// RUN: %clipc -T vs_5_0 %s -D BUFFER --validate -o - | FileCheck %s --check-prefix=EXACT
// RUN: %clipc -T vs_5_0 %s --target=vulkan --validate -o - | FileCheck %s --check-prefix=VULKAN
// RUN: %draw compare %s -T vs_5_0
// RUN: %draw compare %s -T vs_5_0 -D ATTRIBUTE
// CHECK-NOT: #extension
// CHECK: uint(gl_VertexID)
// REFLECT: "needsBaseVertexZero": true
// EXACT: #extension GL_ARB_shader_draw_parameters : require
// EXACT: gl_VertexID - gl_BaseVertexARB
// VULKAN: gl_VertexIndex - gl_BaseVertex
StructuredBuffer<float4> buffer;
float4 main(uint id : SV_VertexID, float4 p : POSITION) : SV_Position {
  float4 corner = float4(id & 1, id >> 1, 0, 1) * float4(4, 4, 1, 1) - float4(1, 1, 0, 0);
#if defined ATTRIBUTE
  corner += p;
#elif defined BUFFER
  corner += buffer[id];
#endif
  return corner;
}
