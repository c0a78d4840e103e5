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
