// A pixel whose discard waits for the end stores nothing after it (Direct3D 11.3 functional specification, 16.9.3).
// RUN: %clipc -T ps_5_0 --validate --verify %s -o - | FileCheck %s
// RUN: %clipc -T ps_5_0 -E in_expression --validate --verify %s -o - | FileCheck %s --check-prefix=EXPRESSION
Texture2D map;
SamplerState linearly;
RWTexture2D<float4> log : register(u1);
RWStructuredBuffer<uint> counts : register(u2);

float4 main(float2 uv : UV) : SV_Target {
  uint before;
  InterlockedAdd(counts[0], 1, before);
  clip(uv);
  log[int2(0, 0)] = map.Sample(linearly, uv);
  counts[1] = 7;
  InterlockedAdd(counts[2], 3);
  return before;
}
// CHECK: bool is_discarded = false;
// CHECK: before = is_discarded ? 0u : atomicAdd(counts[0], 1u);
// CHECK: is_discarded = true;
// CHECK: if (!is_discarded) {
// CHECK-NEXT: imageStore(log_, ivec2(0), texture(map, vs_UV0));
// CHECK: if (!is_discarded) {
// CHECK-NEXT: counts[1] = 7u;
// CHECK: if (!is_discarded) {
// CHECK-NEXT: atomicAdd(counts[2], 3u);
// CHECK: if (is_discarded) {
// CHECK-NEXT: discard;

float4 in_expression(float2 uv : UV) : SV_Target {
  for (int i = 0; i < 4; ++i, clip(uv), clip(uv.x)) uv += 1;
  return uv.x;
}
// EXPRESSION: void clip(vec2 value) {
// EXPRESSION-NEXT: if (any(lessThan(value, vec2(0.0)))) {
// EXPRESSION-NEXT: discard;
// EXPRESSION: void clip(float value) {
// EXPRESSION: clip(uv), clip(uv.x)
