// Under level 9, loops that make an index known are unrolled, and at most 1024 iterations of them: fxc's
// error X3511, "loop does not appear to terminate in a timely manner (1024 iterations)".
// RUN: not %clipc -T vs_4_0_level_9_1 %s -o %t.vert 2>&1 | FileCheck %s
cbuffer Scene {
  float4 plane;
  float4 color;
};

float Sum(float4 v) {
  float sum = 0;
  // CHECK-NOT: error
  for (int a = 0; a < 1024; ++a) sum += v[a % 4];
  // CHECK: fail_long_loops.hlsl:[[#@LINE+1]]:{{[0-9]+}}: error: to know the value, a loop of more than 1024 iterations would be unrolled, and `vs_4_0_level_9_1` unrolls none so long; give the loop fewer iterations [level9-long-loop, X3511]
  for (int b = 0; b < 1025; ++b) sum += v[b % 4];
  // CHECK: :[[#@LINE+1]]:{{[0-9]+}}: error: to know the value, a loop of more than 1024 iterations would be unrolled
  for (int c = 1; c > 0; c++) sum += v[c & 3];
  for (uint d = 5000; d > 0; d -= 2) {
    uint half_of_d = d / 2;
    // CHECK-NOT: error
    sum += plane.x;
    for (int inner = 0; inner < 4; ++inner) sum += v[inner];
  }
  for (uint e = 0; e != 4096; e += 2) {
    uint half_of_e = e / 2;
    // CHECK: :[[#@LINE+1]]:{{[0-9]+}}: error: to know the value, a loop of more than 1024 iterations would be unrolled
    sum += v[half_of_e % 4];
    // CHECK-NOT: error
    for (int inner = 0; inner < 4; ++inner) sum += v[inner];
  }
  // The end of a loop that may break off is not looked for.
  for (int f = 0; f < 4096; ++f) {
    if (f == 3) break;
    sum += v[f];
  }
  return sum;
}

// CHECK-NOT: error
[clipplanes(plane)]
float4 main(float4 p : POSITION) : SV_Position { return p * Sum(p); }
