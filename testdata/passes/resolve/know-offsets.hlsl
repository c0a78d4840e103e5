// An offset by a loop's counter becomes a literal, and the loop is unrolled.
// RUN: %clipc -T ps_5_0 --verify --dump-after=know-offsets --stop-after=know-offsets %s | FileCheck %s
// RUN: %draw compare %s -T ps_5_0
// AUTOUPDATE
Texture2D map;
SamplerState s;
float4 main(float2 uv : UV) : SV_Target {
  float4 sum = 0;
  for (int i = -1; i < 1; ++i) sum += map.Sample(s, uv, int2(i, 0));
  return sum;
}

// CHECK: program ps_5_0 form resolved
// CHECK-NEXT: resource Texture2D<float4> map : t0
// CHECK-NEXT: resource SamplerState s : s0
// CHECK-NEXT: input float2 in_UV0 : UV0 location 0
// CHECK-NEXT: output float4 ps_SV_TARGET0 : SV_Target0 location 0
// CHECK-NEXT: entry float4 main(float2 uv) {
// CHECK-NEXT:   float4 sum = splat<float4>(0.0)
// CHECK-NEXT:   {
// CHECK-NEXT:     sum += sample(map, s, uv, offset: int2(-1, 0))
// CHECK-NEXT:     sum += sample(map, s, uv, offset: int2(0, 0))
// CHECK-NEXT:   }
// CHECK-NEXT:   return sum
// CHECK-NEXT: }
// CHECK-NEXT: main void main.1() {
// CHECK-NEXT:   float4 result = main(in_UV0)
// CHECK-NEXT:   ps_SV_TARGET0 = result
// CHECK-NEXT: }
