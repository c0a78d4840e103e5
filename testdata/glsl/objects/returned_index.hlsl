// A function that returns an element of an array of textures gives its index, and ends without a `return;` of its own.
// RUN: %clipc -T ps_5_1 --target=vulkan --validate %s -o - | FileCheck %s
Texture2D maps[4];
SamplerState s;
// CHECK: void Of(uint i, out uint maps_index) {
// CHECK-NEXT: if (i > 2u) {
// CHECK-NEXT: i = 2u;
// CHECK-NEXT: }
// CHECK-NEXT: maps_index = i;
// CHECK-NEXT: }
Texture2D Of(uint i) {
  if (i > 2) i = 2;
  return maps[i];
}
float4 main(float2 uv : UV, nointerpolation uint k : K) : SV_Target {
  return Of(NonUniformResourceIndex(k)).Sample(s, uv);
}
