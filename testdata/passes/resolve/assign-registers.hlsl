// What has no register gets the first free one, in the order of the text.
// RUN: %clipc -T ps_5_0 --verify --dump-after=assign-registers --stop-after=assign-registers %s | FileCheck %s
// AUTOUPDATE
Texture2D a, b : register(t0), c;
SamplerState s;
cbuffer First { float4 x; };
cbuffer Second : register(b0) { float4 y; };
float4 main(float2 uv : UV) : SV_Target { return a.Sample(s, uv) + b.Sample(s, uv) + c.Sample(s, uv) + x + y; }

// CHECK: program ps_5_0 form resolved
// CHECK-NEXT: cbuffer First : b1, 16 bytes {
// CHECK-NEXT:   float4 x at 0, 16 bytes
// CHECK-NEXT: }
// CHECK-NEXT: cbuffer Second : b0 explicit, 16 bytes {
// CHECK-NEXT:   float4 y at 0, 16 bytes
// CHECK-NEXT: }
// CHECK-NEXT: resource Texture2D<float4> a : t1
// CHECK-NEXT: resource Texture2D<float4> b : t0 explicit
// CHECK-NEXT: resource Texture2D<float4> c : t2
// CHECK-NEXT: resource SamplerState s : s0
// CHECK-NEXT: input float2 in_UV0 : UV0 location 0
// CHECK-NEXT: output float4 ps_SV_TARGET0 : SV_Target0 location 0
// CHECK-NEXT: entry float4 main(float2 uv) {
// CHECK-NEXT:   return (((sample(a, s, uv) + sample(b, s, uv)) + sample(c, s, uv)) + x) + y
// CHECK-NEXT: }
// CHECK-NEXT: main void main.1() {
// CHECK-NEXT:   float4 result = main(in_UV0)
// CHECK-NEXT:   ps_SV_TARGET0 = result
// CHECK-NEXT: }
