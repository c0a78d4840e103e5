// A function that reads the field POSITION of a pixel shader of Direct3D 9, which no register has.
// RUN: not %clipc -T ps_3_0 %s -o - 2>&1 | FileCheck %s
struct Vertex { float4 Pos : POSITION; float4 Diffuse : COLOR; };
float4 Depth(Vertex v) { return v.Pos.z; }
float4 main(Vertex v) : COLOR { return v.Diffuse + Depth(v); }
// CHECK: error: `POSITION` is read; profile `ps_3_0` has no such input of a pixel shader [profile-input, X4502]
