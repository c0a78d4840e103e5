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
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) out float vs_A0;  // A0
// CHECK-NEXT: layout(location = 1) noperspective out float vs_B0;  // B0
// CHECK-NEXT: layout(location = 2) flat out float vs_C0;  // C0
// CHECK-NEXT: layout(location = 3) centroid out float vs_D0;  // D0
// CHECK-NEXT: layout(location = 4) sample out float vs_E0;  // E0
// CHECK-NEXT: layout(location = 5) noperspective centroid out float vs_F0;  // F0
// CHECK-NEXT: layout(location = 6) flat out int vs_G0;  // G0
// CHECK-NEXT: layout(location = 7) flat out double vs_H0;  // H0
// CHECK-EMPTY:
// CHECK-NEXT: void shader_main(vec4 p, out vec4 position, out float a, out float b, out float c, out float d, out float e, out float f, out int g, out double h) {
// CHECK-NEXT:     position = p;
// CHECK-NEXT:     a = b = c = d = e = f = p.x;
// CHECK-NEXT:     g = int(p.y);
// CHECK-NEXT:     h = double(p.z);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     vec4 position;
// CHECK-NEXT:     float a;
// CHECK-NEXT:     float b;
// CHECK-NEXT:     float c;
// CHECK-NEXT:     float d;
// CHECK-NEXT:     float e;
// CHECK-NEXT:     float f;
// CHECK-NEXT:     int g;
// CHECK-NEXT:     double h;
// CHECK-NEXT:     shader_main(in_POSITION0, position, a, b, c, d, e, f, g, h);
// CHECK-NEXT:     gl_Position = position;
// CHECK-NEXT:     vs_A0 = a;
// CHECK-NEXT:     vs_B0 = b;
// CHECK-NEXT:     vs_C0 = c;
// CHECK-NEXT:     vs_D0 = d;
// CHECK-NEXT:     vs_E0 = e;
// CHECK-NEXT:     vs_F0 = f;
// CHECK-NEXT:     vs_G0 = g;
// CHECK-NEXT:     vs_H0 = h;
// CHECK-NEXT: }
