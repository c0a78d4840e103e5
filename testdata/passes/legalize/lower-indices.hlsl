// A matrix of one row is a vector in GLSL and float1 a scalar, so their index is not written; what it changes is.
// RUN: %clipc -T vs_5_0 --verify --validate %s -o - | FileCheck %s
// RUN: %draw compare %s -T vs_5_0 --exact --quarters
int3 start;
struct Output {
  float4 position : SV_Position;
  int3 counts : COUNTS;
  float3 row : ROW;
};
int Next(inout int n) { return n++; }
Output main(float4 p : POSITION) {
  Output o;
  int3 n = start;
  float1x3 rows[2] = {p.xyz, p.yzw};
  float1 one = p.x;
  // CHECK: n.x-- & 0, rows[0] = vec3(0.0)
  rows[0][n[0]-- & 0] = float3(0, 0, 0);
  // CHECK: Next(n.y) & 0, rows[1].y += 2.0
  rows[1][Next(n[1]) & 0].y += 2;
  // CHECK: n.z++ & 0, one = 3.0
  one[n[2]++ & 0] = 3;
  o.position = p;
  // CHECK: (n.y++ & 0, rows[1])
  o.row = rows[1][n[1]++ & 0] + one + rows[0][0];
  o.counts = n;
  return o;
}
