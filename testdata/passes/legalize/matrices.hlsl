// What GLSL has for vectors only is done by helper functions, row by row; the last pass leaves nothing that GLSL lacks.
// RUN: %clipc -T vs_5_0 --verify --dump-after=lower-matrix-operators --stop-after=lower-matrix-operators %s | FileCheck %s --check-prefix=ROWS
// RUN: %clipc -T vs_5_0 --verify --dump-after=lower-functions --stop-after=lower-functions %s | FileCheck %s
float2x2 m, n;
int2 count;

float4 main(float4 p : POSITION) : SV_Position {
  return p * max(m, n)[0].x + (count << count.y).x + rcp(p) + (all(m < n) && p.x > 0 ? 1 : 0);
}

// ROWS: form inlined
// ROWS: max(m, n)
// ROWS: less(m, n)
// ROWS: helper float2x2 max(
// ROWS: return float2x2(max(

// CHECK: program vs_5_0 form legalized
// CHECK: (count << splat<int2>(count.y & 31)).x
// CHECK: splat<float4>(1.0) / in_POSITION0
// CHECK: all(less(m, n)) and_then (in_POSITION0.x > 0.0)
// CHECK: helper float2x2 max(
// CHECK: helper bool2x2 less(
// CHECK: helper bool all(bool2x2 [[M:[a-z0-9.]+]]) {
// CHECK-NEXT: return all([[M]][0u]) and_then all([[M]][1u])
