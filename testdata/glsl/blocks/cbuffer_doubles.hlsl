// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=glsl400 --validate %s -o %t
// AUTOUPDATE
cbuffer Fits {
  double2 d2;
  double d;
  float f;
}
cbuffer Rows {
  double3 d3;
  float tail;
}

float4 main(float4 p : POSITION) : SV_Position {
  double2 sum = d2 * d + (double)f * 0.1L;
  return p + (float)(sum.x + sum.y) + (float)dot(d3, d3) + tail + float(asdouble(1u, 2u)) + (float)fma(d, d, d);
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 0) uniform Fits {  // b0
// CHECK-NEXT:     dvec2 d2;
// CHECK-NEXT:     double d;
// CHECK-NEXT:     float f;
// CHECK-NEXT: } fits;
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 1) uniform Rows {  // b1
// CHECK-NEXT:     dvec3 d3;
// CHECK-NEXT:     float tail;
// CHECK-NEXT: } rows;
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     dvec2 sum = fits.d2 * fits.d + double(fits.f) * 0.1lf;
// CHECK-NEXT:     gl_Position = in_POSITION0 + float(sum.x + sum.y) + float(dot(rows.d3, rows.d3)) + rows.tail + float(packDouble2x32(uvec2(1u, 2u))) + float(fma(fits.d, fits.d, fits.d));
// CHECK-NEXT: }
