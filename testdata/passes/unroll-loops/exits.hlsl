// `break`, `continue` and `return` under conditions that are not known, in loops that are unrolled: a loop of one iteration takes their place.
// RUN: %clipc %s -T ps_4_0 --target=webgl1 --validate --verify -o - | FileCheck %s
// RUN: %draw compare %s -T ps_4_0 --target essl100,glsl450 --seed 3
// RUN: %draw compare %s -T ps_4_0 --target essl100,glsl450 --seed 4
float4 k[12];
float Early(float x, int n) {
  int i = n;
  while (i-- > 0) {
    if (x > k[i].x) return i;
    x += 0.25;
  }
  return -1;
}
// CHECK-LABEL: void main
float4 main(float4 p : T) : SV_Target {
  float4 c = p;
  // CHECK: for (int once = 0; once < 1; once++) {
  // CHECK: if (SV_Target0.x > 1.0) {
  // CHECK-NEXT: z = 0;
  // CHECK-NEXT: break;
  // CHECK: z = 3;
  // CHECK: SV_Target0 += float(z);
  int z = 0;
  do {
    c.x += 0.75;
    if (c.x > 1) break;
    z++;
  } while (z < 3);
  c += z;
  // CHECK: bool left = false;
  // CHECK: continue;
  // CHECK: left = true;
  // CHECK: if (left) {
  // CHECK-NEXT: break;
  int v = 0;
  while (v < 4 && c.y > -2) {
    v++;
    if (c.x > 3) continue;
    c.y -= v * 0.5;
    if (c.z > 2) break;
    c.z += 1;
  }
  c += v;
  // What the paths to the next iteration disagree about is a variable again.
  int d = 0;
  for (int a = 0, b = 0; a < 4; a++, b += a) {
    if (c.w > a) {
      d += 2;
      continue;
    }
    d += b;
    if (c.x < -1 && c.y < 0) {
      d = 7;
      break;
    }
  }
  c.w += d;
  // The end of the loop is one of several ways out of it.
  int e = 0;
  for (;;) {
    e += 2;
    if (e == 4) continue;
    if (p.x > 0 && e < 6) continue;
    if (p.y > e) break;
    if (e > 7) break;
  }
  c.z += e;
  // A loop that stays has a loop in it that is unrolled.
  for (int outer = 0; outer < 3; outer++) {
    int inner = 0;
    while (inner < 2) {
      inner++;
      if (p.z > outer) break;
      c.x += inner;
    }
    d += inner;
  }
  c.x += d + Early(p.x, 3) + Early(p.y, 2);
  return c;
}
