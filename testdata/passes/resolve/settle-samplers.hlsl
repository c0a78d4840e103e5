// A sampler that is read as a texture is one, and a texture of its own where a method samples with it too.
// RUN: %clipc -T ps_4_0 --verify --dump-after=settle-samplers --stop-after=settle-samplers %s | FileCheck %s
// AUTOUPDATE
sampler s;
Texture2D t;
float4 main(float2 uv : UV) : SV_Target { return tex2D(s, uv) + t.Sample(s, uv); }

// CHECK: program ps_4_0 form resolved
// CHECK-NEXT: resource sampler2D s.1 : t0
// CHECK-NEXT: resource SamplerState s : s0
// CHECK-NEXT: resource Texture2D<float4> t : t0
// CHECK-NEXT: input float2 in_UV0 : UV0 location 0
// CHECK-NEXT: output float4 ps_SV_TARGET0 : SV_Target0 location 0
// CHECK-NEXT: entry float4 main(float2 uv) {
// CHECK-NEXT:   return d3d9_sample(s.1, uv) + sample(t, s, uv)
// CHECK-NEXT: }
// CHECK-NEXT: main void main.1() {
// CHECK-NEXT:   float4 result = main(in_UV0)
// CHECK-NEXT:   ps_SV_TARGET0 = result
// CHECK-NEXT: }
