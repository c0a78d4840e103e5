// Program pipelines want gl_PerVertex redeclared (section 7.1.1), from GLSL 4.10 on.
// RUN: %clipc -T vs_5_0 --separable --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --separable --target=glsl330 --validate %s -o - | FileCheck %s --check-prefix=OLD
// AUTOUPDATE
float4 main(float4 p : POSITION) : SV_Position { return p; }

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: out gl_PerVertex {
// CHECK-NEXT:     vec4 gl_Position;
// CHECK-NEXT:     float gl_PointSize;
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     gl_Position = in_POSITION0;
// CHECK-NEXT: }

// OLD: #version 330
// OLD-EMPTY:
// OLD-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// OLD-EMPTY:
// OLD-NEXT: void main() {
// OLD-NEXT:     gl_Position = in_POSITION0;
// OLD-NEXT: }

// A pixel shader has no such block.
// RUN: %clipc %s -T ps_5_0 -E pixel --separable --validate -o - | FileCheck %s --check-prefix=PIXEL --implicit-check-not=gl_PerVertex
// PIXEL: void main() {
float4 pixel(float4 c : COLOR0) : SV_Target { return c; }
