// Draws without a base vertex and a base instance need no draw parameters.
// RUN: %clipc -T vs_5_0 %s --target=vulkan --validate -o - --base-vertex=zero --base-instance=zero | FileCheck %s --check-prefix=VULKAN
// RUN: %clipc -T vs_5_0 %s --target=glsl450 --validate -o - --base-vertex=zero | FileCheck %s --check-prefix=OPENGL
// RUN: %clipc -T vs_5_0 %s --target=vulkan -o /dev/null --reflect=- --base-vertex=zero --base-instance zero | FileCheck %s --check-prefix=JSON
// RUN: %clipc -T vs_5_0 %s --target=vulkan -o - | FileCheck %s --check-prefix=BASES
// VULKAN: uint(gl_VertexIndex)
// VULKAN: uint(gl_InstanceIndex)
// OPENGL-NOT: #extension
// OPENGL: uint(gl_VertexID)
// OPENGL: uint(gl_InstanceID)
// JSON: "needsBaseVertexZero": true
// JSON: "needsBaseInstanceZero": true
// BASES: uint(gl_VertexIndex - gl_BaseVertex)
// BASES: uint(gl_InstanceIndex - gl_BaseInstance)
float4 main(uint vertex : SV_VertexID, uint instance : SV_InstanceID) : SV_Position {
  return float4(vertex, instance, 0, 1);
}
