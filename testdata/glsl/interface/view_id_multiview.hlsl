// OpenGL has views through OVR_multiview, which wants their number: two, a headset's.
// RUN: %clipc -T vs_6_1 --target=glsl330 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_6_1 --target=glsl450 --validate %s -o %t
// AUTOUPDATE
float4 main(uint view : SV_ViewID) : SV_Position { return view; }

// CHECK: #version 330
// CHECK-NEXT: #extension GL_OVR_multiview2 : require
// CHECK-EMPTY:
// CHECK-NEXT: layout(num_views = 2) in;  // view : SV_ViewID0
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     uint view = uint(gl_ViewID_OVR);
// CHECK-NEXT:     gl_Position = vec4(float(view));
// CHECK-NEXT: }
