// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=essl320 --validate %s -o %t
// RUN: %clipc -T vs_5_0 --target=glsl330 --validate %s -o - | FileCheck %s --check-prefix=OLD
// AUTOUPDATE
float4 a;
float4 main(float4 p : POSITION) : SV_Position {
  precise float4 r = p * a + 1;
  return r;
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 0) uniform Globals {  // b0
// CHECK-NEXT:     vec4 a;
// CHECK-NEXT: } globals;
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     precise vec4 r = in_POSITION0 * globals.a + 1.0;
// CHECK-NEXT:     gl_Position = r;
// CHECK-NEXT: }

// OLD: #version 330
// OLD-EMPTY:
// OLD-NEXT: layout(std140) uniform Globals {  // b0
// OLD-NEXT:     vec4 a;
// OLD-NEXT: } globals;
// OLD-EMPTY:
// OLD-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// OLD-EMPTY:
// OLD-NEXT: void main() {
// OLD-NEXT:     vec4 r = in_POSITION0 * globals.a + 1.0;
// OLD-NEXT:     gl_Position = r;
// OLD-NEXT: }
