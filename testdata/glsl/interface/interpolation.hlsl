// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// AUTOUPDATE
void main(float4 p : POSITION, out float4 position : SV_Position, out linear float a : A, out noperspective float b : B,
          out nointerpolation float c : C, out centroid float d : D, out sample float e : E,
          out noperspective centroid float f : F, out int g : G, out double h : H) {
  position = p;
  a = b = c = d = e = f = p.x;
  g = (int)p.y;
  h = p.z;
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) out float vs_A0;  // a : A0
// CHECK-NEXT: layout(location = 1) noperspective out float vs_B0;  // b : B0
// CHECK-NEXT: layout(location = 2) flat out float vs_C0;  // c : C0
// CHECK-NEXT: layout(location = 3) centroid out float vs_D0;  // d : D0
// CHECK-NEXT: layout(location = 4) sample out float vs_E0;  // e : E0
// CHECK-NEXT: layout(location = 5) noperspective centroid out float vs_F0;  // f : F0
// CHECK-NEXT: layout(location = 6) flat out int vs_G0;  // g : G0
// CHECK-NEXT: layout(location = 7) flat out double vs_H0;  // h : H0
// CHECK-EMPTY:
// CHECK-NEXT: int to_int(float x) {
// CHECK-NEXT:     return x < 2147483648.0 ? int(max(-2147483648.0, x)) : x > 0.0 ? 2147483647 : 0;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     gl_Position = in_POSITION0;
// CHECK-NEXT:     vs_A0 = vs_B0 = vs_C0 = vs_D0 = vs_E0 = vs_F0 = in_POSITION0.x;
// CHECK-NEXT:     vs_G0 = to_int(in_POSITION0.y);
// CHECK-NEXT:     vs_H0 = double(in_POSITION0.z);
// CHECK-NEXT: }
