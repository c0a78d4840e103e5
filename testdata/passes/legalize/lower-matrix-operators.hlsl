// Operators and functions of matrices that GLSL has for vectors only are done row by row, by helper functions.
// RUN: %clipc -T vs_5_0 --verify --dump-after=lower-matrix-operators --stop-after=lower-matrix-operators %s | FileCheck %s
// RUN: %draw compare %s -T vs_5_0
// AUTOUPDATE
float2x2 m, n;
int2x2 i;

float4 main(float4 p : POSITION) : SV_Position {
  float2x2 larger = max(m, n);
  bool2x2 below = m < n;
  int2x2 counted = i;
  int2x2 old = counted++;
  return p + larger[0].xyxy + (m + n)[1].xyxy + (below[1].x ? 1 : 0) + old[0].xyxy + counted[1].xyxy;
}

// CHECK: program vs_5_0 form inlined
// CHECK-NEXT: globals $Globals : b0, 96 bytes {
// CHECK-NEXT:   float2x2 m at 0, 24 bytes
// CHECK-NEXT:   float2x2 n at 32, 24 bytes
// CHECK-NEXT:   int2x2 i at 64, 24 bytes
// CHECK-NEXT: }
// CHECK-NEXT: input float4 in_POSITION0 : POSITION0 location 0
// CHECK-NEXT: output float4 vs_SV_POSITION0 : SV_Position0 builtin position
// CHECK-NEXT: entry void main() {
// CHECK-NEXT: }
// CHECK-NEXT: main void main.1() {
// CHECK-NEXT:   float2x2 larger = max(m, n)
// CHECK-NEXT:   bool2x2 below = less(m, n)
// CHECK-NEXT:   int2x2 counted = i
// CHECK-NEXT:   int2x2 old = post_increment(counted)
// CHECK-NEXT:   vs_SV_POSITION0 = ((((in_POSITION0 + larger[0].xyxy) + (m + n)[1].xyxy) + splat<float4>(convert<float>(below[1].x ? 1 : 0))) + convert<float4>(old[0].xyxy)) + convert<float4>(counted[1].xyxy)
// CHECK-NEXT: }
// CHECK-NEXT: helper float2x2 max(float2x2 a, float2x2 b) {
// CHECK-NEXT:   return float2x2(max(a[0u], b[0u]), max(a[1u], b[1u]))
// CHECK-NEXT: }
// CHECK-NEXT: helper bool2x2 less(float2x2 a.1, float2x2 b.1) {
// CHECK-NEXT:   return bool2x2(a.1[0u] < b.1[0u], a.1[1u] < b.1[1u])
// CHECK-NEXT: }
// CHECK-NEXT: helper int2x2 post_increment(inout int2x2 m.1) {
// CHECK-NEXT:   int2x2 before = m.1
// CHECK-NEXT:   m.1[0u]++
// CHECK-NEXT:   m.1[1u]++
// CHECK-NEXT:   return before
// CHECK-NEXT: }
