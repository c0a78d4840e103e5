// RUN: %clipc -T vs_6_8 --target=glsl460 --validate %s -o - | FileCheck %s --check-prefix=GL460
// RUN: %clipc -T vs_6_8 --target=glsl450 --validate %s -o - | FileCheck %s --check-prefix=GL450
// RUN: %clipc -T vs_6_8 --target=vulkan --validate %s -o %t
// AUTOUPDATE
float4 main(int first : SV_StartVertexLocation, uint instance : SV_StartInstanceLocation) : SV_Position {
  return float4(first, instance, 0, 1);
}

// GL460: #version 460
// GL460-EMPTY:
// GL460-NEXT: void main() {
// GL460-NEXT:     int first = int(gl_BaseVertex);
// GL460-NEXT:     uint instance = uint(gl_BaseInstance);
// GL460-NEXT:     gl_Position = vec4(float(first), float(instance), 0.0, 1.0);
// GL460-NEXT: }

// GL450: #version 450
// GL450-NEXT: #extension GL_ARB_shader_draw_parameters : require
// GL450-EMPTY:
// GL450-NEXT: void main() {
// GL450-NEXT:     int first = int(gl_BaseVertexARB);
// GL450-NEXT:     uint instance = uint(gl_BaseInstanceARB);
// GL450-NEXT:     gl_Position = vec4(float(first), float(instance), 0.0, 1.0);
// GL450-NEXT: }
