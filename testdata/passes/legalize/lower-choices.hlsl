// Logical operators evaluate what they need when that is all the same, else both sides; a choice between matrices is one by a scalar.
// RUN: %clipc -T vs_5_0 --verify --dump-after=lower-choices --stop-after=lower-choices %s | FileCheck %s
// RUN: %draw compare %s -T vs_5_0
// AUTOUPDATE
float4 main(float4 p : POSITION, float4 q : OTHER) : SV_Position {
  int changes = 0;
  bool either = p.x > 0 || q.x > 0;
  bool both = p.y > 0 && changes++ == 0;
  bool2 each = (p.xy > 0) && (q.xy > 0);
  float2 chosen = p.x > q.x ? p.xy : q.xy;
  float2 mixed = p.xy > q.xy ? p.zw : q.zw;
  return float4(chosen, mixed) + (either ? 1 : 0) + (both ? 2 : 0) + (each.x ? 4 : 0) + changes;
}

// CHECK: program vs_5_0 form inlined
// CHECK-NEXT: input float4 in_POSITION0 : POSITION0 location 0
// CHECK-NEXT: input float4 in_OTHER0 : OTHER0 location 1
// CHECK-NEXT: output float4 vs_SV_POSITION0 : SV_Position0 builtin position
// CHECK-NEXT: entry void main() {
// CHECK-NEXT: }
// CHECK-NEXT: main void main.1() {
// CHECK-NEXT:   int changes = 0
// CHECK-NEXT:   bool either = (in_POSITION0.x > 0.0) or_else (in_OTHER0.x > 0.0)
// CHECK-NEXT:   bool both = all(bool2(in_POSITION0.y > 0.0, (changes++) == 0))
// CHECK-NEXT:   bool2 each = logical_and(in_POSITION0.xy > splat<float2>(0.0), in_OTHER0.xy > splat<float2>(0.0))
// CHECK-NEXT:   float2 chosen = (in_POSITION0.x > in_OTHER0.x) ? in_POSITION0.xy : in_OTHER0.xy
// CHECK-NEXT:   float2 mixed = select(in_POSITION0.xy > in_OTHER0.xy, in_POSITION0.zw, in_OTHER0.zw)
// CHECK-NEXT:   vs_SV_POSITION0 = (((float4(chosen, mixed) + splat<float4>(convert<float>(either ? 1 : 0))) + splat<float4>(convert<float>(both ? 2 : 0))) + splat<float4>(convert<float>(each.x ? 4 : 0))) + splat<float4>(convert<float>(changes))
// CHECK-NEXT: }
// CHECK-NEXT: helper bool2 logical_and(bool2 a, bool2 b) {
// CHECK-NEXT:   return bool2(a.x and_then b.x, a.y and_then b.y)
// CHECK-NEXT: }
