// fxc inlines functions, so a pixel shader of Direct3D 9 may hand on the struct with POSITION, which no register has, to functions that do
// not read it.
// RUN: %clipc -T ps_3_0 %s --validate -o - | FileCheck %s
struct Vertex { float4 Pos : POSITION; float4 Diffuse : COLOR; float2 Tex : TEXCOORD0; };
sampler Map;
float4 Inner(Vertex v) { return v.Diffuse; }
float4 Shade(Vertex v, uniform bool lit) { return lit ? tex2D(Map, v.Tex) * Inner(v) : v.Diffuse; }
float4 main(Vertex v) : COLOR { return Shade(v, true) + tex2D(Map, v.Tex); }
// CHECK: Vertex v = Vertex(vec4(0.0), vs_COLOR0, vs_TEXCOORD0);
// CHECK-NEXT: SV_Target0 = Shade(v, true)
// RUN: %draw compare %s -T ps_3_0
