// `a op= b` that GLSL lacks becomes `a = a op b`, or a helper function where `a` has effects.
// RUN: %clipc -T vs_5_0 --verify --dump-after=lower-assignments --stop-after=lower-assignments %s | FileCheck %s
// RUN: %draw compare %s -T vs_5_0
// AUTOUPDATE
float2x2 m;

float4 main(float4 p : POSITION, uint n : COUNT, int2 k : KEY) : SV_Position {
  float2x2 product = m;
  product *= m;
  product += m;
  uint rest = n;
  rest %= 3u;
  int rests[2] = {k.x, k.y};
  int next = 0;
  rests[next++ & 1] %= 5;
  return p + product[0].xyxy + rest + rests[0] + next;
}

// CHECK: program vs_5_0 form inlined
// CHECK-NEXT: globals $Globals : b0, 32 bytes {
// CHECK-NEXT:   float2x2 m at 0, 24 bytes
// CHECK-NEXT: }
// CHECK-NEXT: input float4 in_POSITION0 : POSITION0 location 0
// CHECK-NEXT: input uint in_COUNT0 : COUNT0 location 1
// CHECK-NEXT: input int2 in_KEY0 : KEY0 location 2
// CHECK-NEXT: output float4 vs_SV_POSITION0 : SV_Position0 builtin position
// CHECK-NEXT: entry void main() {
// CHECK-NEXT: }
// CHECK-NEXT: main void main.1() {
// CHECK-NEXT:   float2x2 product = m
// CHECK-NEXT:   product = product * m
// CHECK-NEXT:   product += m
// CHECK-NEXT:   uint rest = in_COUNT0
// CHECK-NEXT:   rest %= 3u
// CHECK-NEXT:   int rests[2] = int[2]{in_KEY0.x, in_KEY0.y}
// CHECK-NEXT:   int next = 0
// CHECK-NEXT:   assign_modulo(rests[(next++) & 1], 5)
// CHECK-NEXT:   vs_SV_POSITION0 = (((in_POSITION0 + product[0].xyxy) + splat<float4>(convert<float>(rest))) + splat<float4>(convert<float>(rests[0]))) + splat<float4>(convert<float>(next))
// CHECK-NEXT: }
// CHECK-NEXT: helper int assign_modulo(inout int target, int value) {
// CHECK-NEXT:   target = target % value
// CHECK-NEXT:   return target
// CHECK-NEXT: }
