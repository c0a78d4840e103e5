// Functions that work by component take the part that all their matrices have, as in fxc.
// RUN: %clipc -T vs_5_0 -E main --dump=ir %s 2>%t.warnings | FileCheck %s
// RUN: FileCheck %s --check-prefix=WARNING < %t.warnings
// RUN: %draw compare %s -T vs_5_0 -E main
row_major float3x2 tall;
row_major float2x3 wide;
float3x4 large;
struct Output {
  float4 position : SV_Position;
  float4 part : PART;
  float4 limited : LIMITED;
  float4 mixed : MIXED;
  float4 power : POWER;
};
Output main() {
  Output o;
  o.position = 1;
  // WARNING: [[#@LINE+3]]:23: warning: implicit truncation of vector type `float3x2` to `float2x2` [-Wimplicit-truncation]
  // WARNING: [[#@LINE+2]]:29: warning: implicit truncation of vector type `float2x3` to `float2x2` [-Wimplicit-truncation]
  // CHECK: float2x2 part = max(truncate<float2x2>(tall), truncate<float2x2>(wide))
  float2x2 part = max(tall, wide);
  o.part = part;
  o.limited = float4(clamp(tall, wide, large));
  o.mixed = float4(lerp(wide, tall, 0.5)) + float4(smoothstep(wide * 0 - 2, 2, tall)) + float4(step(wide, tall));
  o.power = float4(pow(abs(tall) + 0.5, wide)) + float4(ldexp(wide, tall)) + float4(min(wide, tall));
  return o;
}
