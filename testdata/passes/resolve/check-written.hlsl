// An output that nothing writes is marked, and the writer gives it zeros.
// RUN: %clipc -T vs_5_0 --verify --dump-after=check-written --stop-after=check-written -w %s | FileCheck %s
// AUTOUPDATE
struct Out {
  float4 position : SV_Position;
  float4 color : COLOR;
};
Out main(float4 p : POSITION) {
  Out o;
  o.position = p;
  return o;
}

// CHECK: program vs_5_0 form typed
// CHECK-NEXT: struct Out {
// CHECK-NEXT:   float4 position : SV_Position
// CHECK-NEXT:   float4 color : COLOR
// CHECK-NEXT: }
// CHECK-NEXT: input float4 in_POSITION0 : POSITION0 location 0
// CHECK-NEXT: output float4 vs_SV_POSITION0 : SV_Position0 builtin position
// CHECK-NEXT: output float4 vs_COLOR0 : COLOR0 location 0
// CHECK-NEXT: entry Out main(float4 p) {
// CHECK-NEXT:   Out o
// CHECK-NEXT:   o.position = p
// CHECK-NEXT:   return o
// CHECK-NEXT: }
// CHECK-NEXT: main void main.1() {
// CHECK-NEXT:   Out result = main(in_POSITION0)
// CHECK-NEXT:   vs_SV_POSITION0 = result.position
// CHECK-NEXT:   vs_COLOR0 = result.color
// CHECK-NEXT: }
