// An array of one element, zero as a whole, is an argument, a value and a part of another.
// RUN: %clipc -T vs_5_0 %s -o - --validate | FileCheck %s
// RUN: %clipc -T vs_5_0 %s -o - --validate --target=glsl120
// RUN: %clipc -T vs_5_0 %s -o - --validate --target=essl300
// RUN: %draw compare %s -T vs_5_0
struct One { float x[1]; };
float first(float a[1]) { return a[0] + 1; }
float of_structs(One a[1]) { return a[0].x[0] + 2; }
float nested(float2 a[1][1]) { return a[0][0].x + 3; }
float4 main(float4 v : POSITION) : SV_Position {
  // CHECK-NOT: {{[^n]}}()
  float kept[1] = (float[1])0;
  kept = (float[1])v.x;
  return v * first((float[1])0) + of_structs((One[1])0) + nested((float2[1][1])0) + first(kept);
}
