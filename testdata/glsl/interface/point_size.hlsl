// RUN: %clipc -T vs_3_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_3_0 --target=glsl120 --validate %s -o %t
// AUTOUPDATE
void main(float4 p : POSITION, out float4 position : POSITION, out float size : PSIZE) {
  position = p;
  size = 4;
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     gl_Position = in_POSITION0;
// CHECK-NEXT:     gl_PointSize = 4.0;
// CHECK-NEXT: }
