// Direct3D's discard lets a pixel run on for its neighbours' derivatives; that of GLSL does not. Where a derivative may follow,
// the discard waits for the end.
// RUN: %clipc -T ps_5_0 -E last --validate --verify %s -o - | FileCheck %s --check-prefix=LAST
// RUN: %clipc -T ps_5_0 -E first --validate --verify %s -o - | FileCheck %s --check-prefix=FIRST
// RUN: %clipc -T ps_5_0 -E in_loop --validate --verify %s -o - | FileCheck %s --check-prefix=LOOP
// RUN: %clipc -T ps_5_0 -E in_function --validate --verify %s -o - | FileCheck %s --check-prefix=FUNCTION
// RUN: %clipc -T ps_5_0 -E first --target=essl100 --validate --verify %s -o - | FileCheck %s --check-prefix=ES
Texture2D map;
SamplerState linearly;

float4 last(float2 uv : UV) : SV_Target {
  float4 color = map.Sample(linearly, uv);
  clip(color.a - 0.5);
  if (color.r == 0) discard;
  return color;
}
// LAST-NOT: is_discarded
// LAST: if (SV_Target0.w - 0.5 < 0.0) {
// LAST-NEXT: discard;
// LAST-NEXT: }
// LAST-NEXT: if (SV_Target0.x == 0.0) {
// LAST-NEXT: discard;

float4 first(float2 uv : UV) : SV_Target {
  clip(uv - 0.5);
  return map.Sample(linearly, uv);
}
// FIRST: bool is_discarded = false;
// FIRST: if (any(lessThan(vs_UV0 - 0.5, vec2(0.0)))) {
// FIRST-NEXT: is_discarded = true;
// FIRST: SV_Target0 = texture(map, vs_UV0);
// FIRST-NEXT: if (is_discarded) {
// FIRST-NEXT: discard;
// ES: bool is_discarded = false;
// ES: gl_FragData[0] = SV_Target0;

float4 in_loop(float2 uv : UV) : SV_Target {
  float4 sum = 0;
  for (int i = 0; i < 4; ++i) {
    sum += map.Sample(linearly, uv * i);
    if (sum.a > 1) discard;
  }
  if (sum.b > 1) discard;
  return sum;
}
// LOOP: if (SV_Target0.w > 1.0) {
// LOOP-NEXT: is_discarded = true;
// LOOP: if (SV_Target0.z > 1.0) {
// LOOP-NEXT: discard;

void test(float a) {
  if (a < 0) discard;
}
float4 in_function(float2 uv : UV) : SV_Target {
  test(uv.x);
  float4 color = map.Sample(linearly, uv);
  test(uv.y);
  return color;
}
// FUNCTION: void test(
// FUNCTION: is_discarded = true;
