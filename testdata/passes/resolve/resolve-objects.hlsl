// A texture in a struct, a local variable and a parameter is the global one, and a function is copied for each tuple of objects.
// RUN: %clipc -T ps_5_0 --verify --dump-after=resolve-objects --stop-after=resolve-objects %s | FileCheck %s
// RUN: %draw compare %s -T ps_5_0
// AUTOUPDATE
Texture2D wood, stone;
SamplerState s;
struct Material {
  Texture2D map;
  float weight;
};
float4 Read(Material material, float2 uv) { return material.map.Sample(s, uv) * material.weight; }
float4 main(float4 uv : UV) : SV_Target {
  Material a = {wood, 2}, b = {stone, 3};
  Texture2D kept = b.map;
  return Read(a, uv.xy) + Read(b, uv.xy) + (kept, uv) + kept.Sample(s, uv.zw);
}

// CHECK: program ps_5_0 form typed
// CHECK-NEXT: struct Material {
// CHECK-NEXT:   float weight
// CHECK-NEXT: }
// CHECK-NEXT: resource Texture2D<float4> wood : t0
// CHECK-NEXT: resource Texture2D<float4> stone : t0
// CHECK-NEXT: resource SamplerState s : s0
// CHECK-NEXT: input float4 in_UV0 : UV0 location 0
// CHECK-NEXT: output float4 ps_SV_TARGET0 : SV_Target0 location 0
// CHECK-NEXT: float4 Read(Material material.1, float2 uv.2) {
// CHECK-NEXT:   return sample(wood, s, uv.2) * splat<float4>(material.1.weight)
// CHECK-NEXT: }
// CHECK-NEXT: float4 Read.1(Material material.2, float2 uv.3) {
// CHECK-NEXT:   return sample(stone, s, uv.3) * splat<float4>(material.2.weight)
// CHECK-NEXT: }
// CHECK-NEXT: entry float4 main(float4 uv) {
// CHECK-NEXT:   Material a = Material{2.0}
// CHECK-NEXT:   Material b = Material{3.0}
// CHECK-NEXT:   return ((Read(a, uv.xy) + Read.1(b, uv.xy)) + uv) + sample(stone, s, uv.zw)
// CHECK-NEXT: }
// CHECK-NEXT: main void main.1() {
// CHECK-NEXT:   float4 result = main(in_UV0)
// CHECK-NEXT:   ps_SV_TARGET0 = result
// CHECK-NEXT: }
