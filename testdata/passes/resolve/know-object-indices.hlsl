// A loop over a local array of textures is unrolled, so that each index is a literal.
// RUN: %clipc -T ps_5_0 --verify --dump-after=know-object-indices --stop-after=know-object-indices %s | FileCheck %s
// RUN: %draw compare %s -T ps_5_0
// AUTOUPDATE
Texture2D first, second;
SamplerState s;
float4 main(float2 uv : UV) : SV_Target {
  Texture2D maps[2] = {first, second};
  float4 sum = 0;
  for (int i = 0; i < 2; ++i) sum += maps[i].Sample(s, uv);
  return sum;
}

// CHECK: program ps_5_0 form typed
// CHECK-NEXT: resource Texture2D<float4> first : t0
// CHECK-NEXT: resource Texture2D<float4> second : t0
// CHECK-NEXT: resource SamplerState s : s0
// CHECK-NEXT: input float2 in_UV0 : UV0 location 0
// CHECK-NEXT: output float4 ps_SV_TARGET0 : SV_Target0 location 0
// CHECK-NEXT: entry float4 main(float2 uv) {
// CHECK-NEXT:   Texture2D<float4> maps[2] = Texture2D<float4>[2]{first, second}
// CHECK-NEXT:   float4 sum = splat<float4>(0.0)
// CHECK-NEXT:   {
// CHECK-NEXT:     sum += sample(maps[0], s, uv)
// CHECK-NEXT:     sum += sample(maps[1], s, uv)
// CHECK-NEXT:   }
// CHECK-NEXT:   return sum
// CHECK-NEXT: }
// CHECK-NEXT: main void main.1() {
// CHECK-NEXT:   float4 result = main(in_UV0)
// CHECK-NEXT:   ps_SV_TARGET0 = result
// CHECK-NEXT: }
