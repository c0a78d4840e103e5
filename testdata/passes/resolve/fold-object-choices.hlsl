// A constant chooses the texture, whatever else is asked.
// RUN: %clipc -T ps_6_0 --verify --dump-after=fold-object-choices --stop-after=fold-object-choices %s | FileCheck %s
// RUN: %draw compare %s -T ps_6_0
// AUTOUPDATE
Texture2D day, night;
SamplerState s;
float4 Read(bool is_day, float2 uv) {
  Texture2D map = is_day || uv.x > 2 ? day : night;
  return map.Sample(s, uv);
}
float4 main(float2 uv : UV) : SV_Target { return Read(true, uv); }

// CHECK: program ps_6_0 form typed
// CHECK-NEXT: resource Texture2D<float4> day : t0
// CHECK-NEXT: resource Texture2D<float4> night : t0
// CHECK-NEXT: resource SamplerState s : s0
// CHECK-NEXT: input float2 in_UV0 : UV0 location 0
// CHECK-NEXT: output float4 ps_SV_TARGET0 : SV_Target0 location 0
// CHECK-NEXT: entry float4 main(float2 uv) {
// CHECK-NEXT:   return Read(true, uv)
// CHECK-NEXT: }
// CHECK-NEXT: float4 Read(bool is_day, float2 uv.1) {
// CHECK-NEXT:   Texture2D<float4> map = day
// CHECK-NEXT:   return sample(map, s, uv.1)
// CHECK-NEXT: }
// CHECK-NEXT: main void main.1() {
// CHECK-NEXT:   float4 result = main(in_UV0)
// CHECK-NEXT:   ps_SV_TARGET0 = result
// CHECK-NEXT: }
