// Neighbouring pixels need the coordinates of the second sample: the discard waits. A discard that nothing reads a derivative
// after stays where it is.
// RUN: %clipc -T ps_5_0 -E waits %s --dump-after=defer-discards | FileCheck %s
// RUN: %clipc -T ps_5_0 -E stays %s --dump-after=defer-discards | FileCheck %s --check-prefix=STAYS
// RUN: %draw compare %s -T ps_5_0 -E waits
// RUN: %draw compare %s -T ps_5_0 -E stays
Texture2D map : register(t0);
SamplerState linear_sampler : register(s0);

float4 waits(float4 p : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    if (uv.x < 0.5)
        discard;
    return map.Sample(linear_sampler, uv);
}

float4 stays(float4 p : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    float4 color = map.Sample(linear_sampler, uv);
    if (uv.x < 0.5)
        discard;
    return color;
}

// CHECK:      main void main() {
// CHECK-NEXT:   if (in_TEXCOORD0.x < 0.5) {
// CHECK-NEXT:     is_discarded = true
// CHECK-NEXT:   }
// CHECK-NEXT:   ps_SV_TARGET0 = sample(map, linear_sampler, in_TEXCOORD0)
// CHECK-NEXT:   if (is_discarded) {
// CHECK-NEXT:     discard

// STAYS-NOT:  is_discarded
// STAYS:      ps_SV_TARGET0 = sample(map, linear_sampler, in_TEXCOORD0)
// STAYS-NEXT: if (in_TEXCOORD0.x < 0.5) {
// STAYS-NEXT:   discard
