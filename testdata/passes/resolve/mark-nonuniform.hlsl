// The mark of an index stands where a texture is chosen.
// RUN: %clipc -T ps_5_1 --verify --dump-after=mark-nonuniform --stop-after=mark-nonuniform %s | FileCheck %s
// AUTOUPDATE
Texture2D maps[4];
float4 main(nointerpolation uint n : N) : SV_Target {
  uint i = NonUniformResourceIndex(n);
  return maps[i].Load(int3(0, 0, 0));
}

// CHECK: program ps_5_1 form resolved
// CHECK-NEXT: resource Texture2D<float4> maps[4] : t0
// CHECK-NEXT: input uint in_N0 : N0 location 0 nointerpolation
// CHECK-NEXT: output float4 ps_SV_TARGET0 : SV_Target0 location 0
// CHECK-NEXT: entry float4 main(uint n) {
// CHECK-NEXT:   uint i = n
// CHECK-NEXT:   return texture_load(maps[NonUniformResourceIndex(i)], int2(0, 0), level: 0)
// CHECK-NEXT: }
// CHECK-NEXT: main void main.1() {
// CHECK-NEXT:   float4 result = main(in_N0)
// CHECK-NEXT:   ps_SV_TARGET0 = result
// CHECK-NEXT: }
