// RUN: %clipc -T vs_6_1 --target=vulkan --validate %s -o - | FileCheck %s
// AUTOUPDATE
float4 main(uint view : SV_ViewID) : SV_Position { return view; }

// CHECK: #version 460
// CHECK-NEXT: #extension GL_EXT_multiview : require
// CHECK-EMPTY:
// CHECK-NEXT: vec4 shader_main(uint view) {
// CHECK-NEXT:     return vec4(float(view));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     vec4 result = shader_main(uint(gl_ViewIndex));
// CHECK-NEXT:     gl_Position = result;
// CHECK-NEXT: }
