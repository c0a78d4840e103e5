// [unroll(N)] ends a loop after N iterations; one that is seen to end by then stays as it is.
// RUN: %clipc -T vs_5_0 %s --validate | FileCheck %s
// RUN: %draw compare %s -T vs_5_0 --target=glsl450,essl300,vulkan
// RUN: %clipc -T vs_5_0 %s -E many --validate | FileCheck %s --check-prefix=MANY
#define ITERATIONS 4
int count;
struct Output {
  float4 position : SV_Position;
  nointerpolation int4 counts : COUNTS;
};
Output main(float4 p : POSITION) {
  Output o = (Output)0;
  o.position = p;
  // CHECK: for (int i = 0; i < 4; ++i) {
  [unroll(ITERATIONS)] for (int i = 0; i < ITERATIONS; ++i) ++o.counts.x;
  // CHECK: int iterations = 0;
  // CHECK-NEXT: for (int j = 0; iterations < 4 && j < 8; ++j, ++iterations) {
  [unroll(4)] for (int j = 0; j < 8; ++j) {
    if (j == 2) continue;
    ++o.counts.y;
  }
  // CHECK: int iterations_2 = 0;
  // CHECK: for (; iterations_2 < 3 && {{.*}}; ++iterations_2) {
  int k = 0;
  [unroll(3)] while (k < (count & 7) + 3) ++k;
  o.counts.z = k;
  // CHECK: while (++iterations_3 < 2 && {{.*}});
  [unroll(2)] do { o.counts.w += 5; } while (o.counts.w < (count & 7) + 20);
  return o;
}
// MANY: for (int i = 8; i > 0; i -= 2) {
// MANY: for (; iterations < 5; ++iterations) {
// MANY: for (uint d = 3u; iterations_2 < 4 && d >= 0u; --d, ++iterations_2) {
// MANY: for (int e = 0; e != 6; e += 2) {
// MANY: for (int f = 0; iterations_3 < 4 && f != 5; f += 2, ++iterations_3) {
float4 many(float4 p : POSITION) : SV_Position {
  [unroll(4)] for (int i = 8; i > 0; i -= 2) p += i;
  [unroll(5)] for (;;) p *= 2;
  // A uint is never below 0, and 5 is never reached.
  [unroll(4)] for (uint d = 3; d >= 0; --d) p += d;
  [unroll(3)] for (int e = 0; e != 6; e += 2) p += e;
  [unroll(4)] for (int f = 0; f != 5; f += 2) p += f;
  return p;
}
