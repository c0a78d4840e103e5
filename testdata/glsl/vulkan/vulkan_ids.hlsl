// Slang's names for Vulkan's numbers: with the first vertex and the first instance of the draw call.
// RUN: %clipc -T vs_6_0 --target=vulkan --validate %s -o - | FileCheck %s --check-prefix=CHECK
// RUN: %clipc -T vs_6_0 --target=glsl450 --validate %s -o - | FileCheck %s --check-prefix=GL
// AUTOUPDATE
float4 main(uint vertex : SV_VulkanVertexID, uint instance : SV_VulkanInstanceID) : SV_Position {
  return float4(vertex, instance, 0, 1);
}

// CHECK: #version 460
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     uint vertex = uint(gl_VertexIndex);
// CHECK-NEXT:     uint instance = uint(gl_InstanceIndex);
// CHECK-NEXT:     gl_Position = vec4(float(vertex), float(instance), 0.0, 1.0);
// CHECK-NEXT: }

// GL: #version 450
// GL-NEXT: #extension GL_ARB_shader_draw_parameters : require
// GL-EMPTY:
// GL-NEXT: void main() {
// GL-NEXT:     uint vertex = uint(gl_VertexID);
// GL-NEXT:     uint instance = uint(gl_InstanceID + gl_BaseInstanceARB);
// GL-NEXT:     gl_Position = vec4(float(vertex), float(instance), 0.0, 1.0);
// GL-NEXT: }
