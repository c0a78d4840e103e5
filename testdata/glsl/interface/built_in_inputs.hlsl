// SV_VertexID has no base vertex, SV_InstanceID no base instance. OpenGL before 3.2 and OpenGL ES before 3.2 cannot draw with a
// base vertex; what OpenGL ES 3.2 would add cannot be subtracted, and --reflect says so. glslang declares gl_BaseVertexARB only
// from 4.50 on.
// RUN: %clipc -T vs_5_0 --target=glsl460 --validate %s -o - | FileCheck %s --check-prefix=GL460
// RUN: %clipc -T vs_5_0 --target=glsl450 --validate %s -o - | FileCheck %s --check-prefix=GL450
// RUN: %clipc -T vs_5_0 --target=glsl330 %s -o - | FileCheck %s --check-prefix=GL330
// RUN: %clipc -T vs_5_0 --target=glsl140 --validate %s -o - | FileCheck %s --check-prefix=GL140
// RUN: %clipc -T vs_5_0 --target=glsl130 %s -o - | FileCheck %s --check-prefix=GL130
// RUN: %clipc -T vs_5_0 --target=glsl130 --validate %s -o %t 2>&1 | FileCheck %s --check-prefix=UNJUDGED
// UNJUDGED: note: not validated: glslang {{[0-9.]+}} does not support `gl_InstanceIDARB` of GL_ARB_draw_instanced
// RUN: %clipc -T vs_5_0 --target=essl300 --validate %s -o - | FileCheck %s --check-prefix=ES300
// RUN: %clipc -T vs_5_0 --target=essl320 --validate %s -o - --reflect %t.json | FileCheck %s --check-prefix=ES320
// RUN: %clipc -T vs_5_0 --target=vulkan --validate %s -o - | FileCheck %s --check-prefix=VULKAN
// AUTOUPDATE
float4 main(float2 p : P, uint vertex : SV_VertexID, uint instance : SV_InstanceID) : SV_Position {
  return float4(vertex, instance, p);
}

// GL460: #version 460
// GL460-EMPTY:
// GL460-NEXT: layout(location = 0) in vec2 in_P0;  // p : P0
// GL460-EMPTY:
// GL460-NEXT: void main() {
// GL460-NEXT:     uint vertex = uint(gl_VertexID - gl_BaseVertex);
// GL460-NEXT:     uint instance = uint(gl_InstanceID);
// GL460-NEXT:     gl_Position = vec4(float(vertex), float(instance), in_P0);
// GL460-NEXT: }

// GL450: #version 450
// GL450-NEXT: #extension GL_ARB_shader_draw_parameters : require
// GL450-EMPTY:
// GL450-NEXT: layout(location = 0) in vec2 in_P0;  // p : P0
// GL450-EMPTY:
// GL450-NEXT: void main() {
// GL450-NEXT:     uint vertex = uint(gl_VertexID - gl_BaseVertexARB);
// GL450-NEXT:     uint instance = uint(gl_InstanceID);
// GL450-NEXT:     gl_Position = vec4(float(vertex), float(instance), in_P0);
// GL450-NEXT: }

// GL330: #version 330
// GL330-EMPTY:
// GL330-NEXT: layout(location = 0) in vec2 in_P0;  // p : P0
// GL330-EMPTY:
// GL330-NEXT: void main() {
// GL330-NEXT:     uint vertex = uint(gl_VertexID);
// GL330-NEXT:     uint instance = uint(gl_InstanceID);
// GL330-NEXT:     gl_Position = vec4(float(vertex), float(instance), in_P0);
// GL330-NEXT: }

// GL140: #version 140
// GL140-EMPTY:
// GL140-NEXT: in vec2 in_P0;  // p : P0
// GL140-EMPTY:
// GL140-NEXT: void main() {
// GL140-NEXT:     uint vertex = uint(gl_VertexID);
// GL140-NEXT:     uint instance = uint(gl_InstanceID);
// GL140-NEXT:     gl_Position = vec4(float(vertex), float(instance), in_P0);
// GL140-NEXT: }

// GL130: #version 130
// GL130-NEXT: #extension GL_ARB_draw_instanced : require
// GL130-EMPTY:
// GL130-NEXT: in vec2 in_P0;  // p : P0
// GL130-EMPTY:
// GL130-NEXT: void main() {
// GL130-NEXT:     uint vertex = uint(gl_VertexID);
// GL130-NEXT:     uint instance = uint(gl_InstanceIDARB);
// GL130-NEXT:     gl_Position = vec4(float(vertex), float(instance), in_P0);
// GL130-NEXT: }

// ES300: #version 300 es
// ES300-EMPTY:
// ES300-NEXT: layout(location = 0) in vec2 in_P0;  // p : P0
// ES300-EMPTY:
// ES300-NEXT: void main() {
// ES300-NEXT:     uint vertex = uint(gl_VertexID);
// ES300-NEXT:     uint instance = uint(gl_InstanceID);
// ES300-NEXT:     gl_Position = vec4(float(vertex), float(instance), in_P0);
// ES300-NEXT: }

// ES320: #version 320 es
// ES320-EMPTY:
// ES320-NEXT: layout(location = 0) in vec2 in_P0;  // p : P0
// ES320-EMPTY:
// ES320-NEXT: void main() {
// ES320-NEXT:     uint vertex = uint(gl_VertexID);
// ES320-NEXT:     uint instance = uint(gl_InstanceID);
// ES320-NEXT:     gl_Position = vec4(float(vertex), float(instance), in_P0);
// ES320-NEXT: }

// VULKAN: #version 460
// VULKAN-EMPTY:
// VULKAN-NEXT: layout(location = 0) in vec2 in_P0;  // p : P0
// VULKAN-EMPTY:
// VULKAN-NEXT: void main() {
// VULKAN-NEXT:     uint vertex = uint(gl_VertexIndex - gl_BaseVertex);
// VULKAN-NEXT:     uint instance = uint(gl_InstanceIndex - gl_BaseInstance);
// VULKAN-NEXT:     gl_Position = vec4(float(vertex), float(instance), in_P0);
// VULKAN-NEXT: }
