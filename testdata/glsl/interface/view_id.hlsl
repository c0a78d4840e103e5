// RUN: %clipc -T vs_6_1 --target=vulkan --validate %s -o - | FileCheck %s
// AUTOUPDATE
float4 main(uint view : SV_ViewID) : SV_Position { return view; }

// CHECK: #version 460
// CHECK-NEXT: #extension GL_EXT_multiview : require
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     uint view = uint(gl_ViewIndex);
// CHECK-NEXT:     gl_Position = vec4(float(view));
// CHECK-NEXT: }
