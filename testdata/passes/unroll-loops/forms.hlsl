// Loops that GLSL ES 1.00 does not have and that are constant after folding, as fxc unrolls them for the profiles without loops; loops
// that appendix A has stay. A function is copied for the constants of its calls.
// RUN: %clipc %s -T ps_3_0 --target=webgl1 --validate --verify -o - | FileCheck %s
// RUN: %clipc %s -T ps_3_0 --target=essl300 -o - | FileCheck %s --check-prefix=FREE
// RUN: %draw compare %s -T ps_3_0 --target essl100,glsl450
// FREE-NOT: once
float4 k[12];
// CHECK-LABEL: vec4 Sum(vec4 p) {
// CHECK: for (int i = 0; i < 3; i++) {
// CHECK-LABEL: vec4 Sum_2(vec4 p) {
// CHECK: for (int i = 0; i < 2; i++) {
float4 Sum(float4 p, uniform int n) {
  float4 sum = 0;
  for (int i = 0; i < n; i++) sum += k[i] * p;
  return sum;
}
// CHECK-LABEL: void main
float4 main(float4 p : TEXCOORD0) : COLOR {
  float4 c = Sum(p, 3) + Sum(p, 2) * Sum(p, 3);
  // CHECK: for (int bound = 0; bound < 2; bound++) {
  const int n = 3;
  int m = n - 1;
  for (int bound = 0; bound < m; bound++) c += k[bound + 2];
  // CHECK: SV_Target0.x += 0.0;
  // CHECK-NEXT: SV_Target0.x += 1.0;
  // CHECK-NEXT: SV_Target0.x += 3.0;
  int t = 0;
  for (int comma = 0; comma < 3; ++comma, t += comma) c.x += t;
  // CHECK-NEXT: SV_Target0 += k(3);
  // CHECK-NEXT: SV_Target0 += k(2);
  // CHECK-NEXT: SV_Target0 += k(1);
  // CHECK-NEXT: SV_Target0 += k(0);
  int down = 4;
  while (down-- > 0) c += k[down];
  // CHECK-NEXT: SV_Target0.y += 0.0;
  // CHECK-NEXT: SV_Target0.y += 7.0;
  // CHECK-NEXT: SV_Target0.y += 12.0;
  for (int first = 0, last = 8; first < last - 2; first++, last--) c.y += first * last;
  // CHECK-NEXT: SV_Target0.z += 0.0;
  // CHECK-NEXT: SV_Target0.z += 2.0;
  // CHECK-NEXT: SV_Target0.w += 4.0;
  int g = 0;
  while (g < 4) {
    c.z += g;
    g += 2;
  }
  c.w += g;
  // CHECK-NEXT: SV_Target0 += k(2);
  // CHECK-NEXT: SV_Target0 += k(3);
  // CHECK-NEXT: SV_Target0 += 4.0;
  int after;
  for (after = 0; after < 4; after++)
    if (after > 1) c += k[after];
  c += after;
  // CHECK-NEXT: SV_Target0 -= k(0);
  // CHECK-NEXT: SV_Target0 -= k(1);
  // CHECK-NEXT: SV_Target0 -= k(2);
  // CHECK-NEXT: SV_Target0 -= k(3);
  int q = 0;
  for (int y = 0; y < 2; y++)
    for (int x = 0; x < 2; x++) c -= k[q++];
  // CHECK-NEXT: SV_Target0 += k(4);
  // CHECK-NEXT: SV_Target0 += k(5);
  // CHECK-NEXT: SV_Target0 += k(7);
  // CHECK-NEXT: SV_Target0 += k(8);
  for (int row = 0; row < 2; row++)
    for (int column = 1; column < 3; column++) {
      int place = row * 3 + column;
      c += k[place + 3];
    }
  // The float counter of a loop that a float ends.
  // CHECK-NEXT: SV_Target0 *= 0.5;
  // CHECK-NEXT: SV_Target0 *= 1.0;
  float half_steps = 0;
  while (half_steps < 1) {
    half_steps += 0.5;
    c *= half_steps;
  }
  // Both counters of components of a vector.
  // CHECK-NEXT: SV_Target0.x += 1.0;
  // CHECK-NEXT: SV_Target0.x += 2.0;
  int2 pair = int2(0, 2);
  do {
    pair += int2(1, -1);
    c.x += pair.x;
  } while (pair.y > 0);
  // An index from a table.
  // CHECK: SV_Target0 += k(2);
  // CHECK-NEXT: SV_Target0 += k(0);
  // CHECK-NEXT: SV_Target0 += k(1);
  int order[3] = { 2, 0, 1 };
  for (int entry = 0; entry < 3; entry++) c += k[order[entry]];
  // CHECK-NEXT: SV_Target0 -= k(2);
  // CHECK-NEXT: SV_Target0 -= k(5);
  const int2 places[2] = { int2(1, 1), int2(2, 3) };
  for (int spot = 0; spot < 2; spot++) c -= k[places[spot].x + places[spot].y];
  return c;
}
