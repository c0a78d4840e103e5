// A float with a fraction where an integer must be known: an error from 6.0 on, as in dxc.
// RUN: not %clipc -T vs_6_0 %s -o %t 2>&1 | FileCheck %s
// AUTOUPDATE
int which;
static const float kSize = 2.75;
float4 main(float4 p : POSITION) : SV_Position {
// CHECK: fail_float_sizes.hlsl:[[#@LINE+3]]:14: error: `4.1` is not a constant integer; it must be known at compile time [not-constant-integer, X3058]
// CHECK-NEXT:     [[#@LINE+2]] |   float four[4.1] = {0, 1, 2, 3};
// CHECK-NEXT:       |              ^~~
  float four[4.1] = {0, 1, 2, 3};
// CHECK-NEXT: fail_float_sizes.hlsl:[[#@LINE+3]]:13: error: `kSize` is not a constant integer; it must be known at compile time [not-constant-integer, X3058]
// CHECK-NEXT:     [[#@LINE+2]] |   float two[kSize] = {4, 5};
// CHECK-NEXT:       |             ^~~~~
  float two[kSize] = {4, 5};
  switch (which) {
// CHECK-NEXT: fail_float_sizes.hlsl:[[#@LINE+3]]:10: error: `2.5` is not a constant integer; it must be known at compile time [not-constant-integer, X3058]
// CHECK-NEXT:    [[#@LINE+2]] |     case 2.5f: p += 0.5; break;
// CHECK-NEXT:       |          ^~~~
    case 2.5f: p += 0.5; break;
    case 3.0: p = -p; break;
  }
  return p + four[which] + two[which & 1];
}
