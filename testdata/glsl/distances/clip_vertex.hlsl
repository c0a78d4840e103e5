// Level 9 on targets that have it: gl_ClipVertex is the position as HLSL wrote it, before any depth range.
// RUN: %clipc -T vs_4_0_level_9_1 --target=glsl120 --depth-range=negative-one-to-one --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_4_0_level_9_1 --target=glsl130 --validate %s -o %t
// RUN: %clipc -T vs_4_0_level_9_1 --target=glsl140 --validate %s -o - --table=%t.json | FileCheck %s --check-prefix=NONE
// AUTOUPDATE
float4 water;
[clipplanes(water)]
float4 main(float4 p : POSITION) : SV_Position { return p; }

// CHECK: #version 120
// CHECK-EMPTY:
// CHECK-NEXT: attribute vec4 in_POSITION0;  // p : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     gl_Position = in_POSITION0;
// CHECK-NEXT:     gl_ClipVertex = gl_Position;
// CHECK-NEXT:     gl_Position.z = 2.0 * gl_Position.z - gl_Position.w;
// CHECK-NEXT: }

// NONE: #version 140
// NONE-EMPTY:
// NONE-NEXT: in vec4 in_POSITION0;  // p : POSITION0
// NONE-EMPTY:
// NONE-NEXT: void main() {
// NONE-NEXT:     gl_Position = in_POSITION0;
// NONE-NEXT: }
