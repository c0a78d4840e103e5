// A float where an integer must be known loses its fraction, as in fxc; dxc refuses it.
// RUN: %clipc -T vs_5_0 -E main --dump=ir %s | FileCheck %s
// RUN: %draw compare %s -T vs_5_0 -E main --ints 0..3
int which;  // one of --ints
static const float kSize = 2.75;
// CHECK: entry
float4 main(float4 p : POSITION) : SV_Position {
  // CHECK: float four[4]
  float four[4.1] = {0, 1, 2, 3};
  // CHECK: float two[2]
  float two[kSize] = {4, 5};
  switch (which) {
    // CHECK: case 2:
    case 2.5f: p += 0.5; break;
    // CHECK: case 0:
    case -0.9: p *= 2; break;
    case 3.0: p = -p; break;
  }
  return p + four[which] + two[which & 1];
}
