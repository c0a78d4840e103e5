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
