// A sampler that the option names compares the third coordinate, as Direct3D 9's driver does.
// RUN: %clipc -T ps_3_0 --shadow-samplers=shadow --verify --dump-after=compare-samplers --stop-after=compare-samplers %s | FileCheck %s
// AUTOUPDATE
sampler2D shadow;
float4 main(float4 p : TEXCOORD) : COLOR { return tex2Dproj(shadow, p); }

// CHECK: program ps_3_0 form resolved
// CHECK-NEXT: resource sampler2DShadow shadow : s0
// CHECK-NEXT: input float4 in_TEXCOORD0 : TEXCOORD0 location 0
// CHECK-NEXT: output float4 ps_COLOR0 : COLOR0 location 0
// CHECK-NEXT: entry float4 main(float4 p) {
// CHECK-NEXT:   return splat<float4>(d3d9_sample_projected(shadow, p))
// CHECK-NEXT: }
// CHECK-NEXT: main void main.1() {
// CHECK-NEXT:   float4 result = main(in_TEXCOORD0)
// CHECK-NEXT:   ps_COLOR0 = result
// CHECK-NEXT: }
