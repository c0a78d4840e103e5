// RUN: %clipc -T vs_3_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_3_0 --target=glsl120 --validate %s -o %t
// AUTOUPDATE
void main(float4 p : POSITION, out float4 position : POSITION, out float size : PSIZE) {
  position = p;
  size = 4;
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: void shader_main(vec4 p, out vec4 position, out float size) {
// CHECK-NEXT:     position = p;
// CHECK-NEXT:     size = 4.0;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     vec4 position;
// CHECK-NEXT:     float size;
// CHECK-NEXT:     shader_main(in_POSITION0, position, size);
// CHECK-NEXT:     gl_Position = position;
// CHECK-NEXT:     gl_PointSize = size;
// CHECK-NEXT: }
