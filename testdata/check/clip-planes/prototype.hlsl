// A prototype's attribute holds for its definition; given on both, they must be the same.
// RUN: %clipc -T vs_4_0 -E main --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_4_0 -E both --validate %s -o - | FileCheck %s
cbuffer Planes { float4 p; };
[clipplanes(p)] float4 main(float4 v : POSITION) : SV_Position;
float4 main(float4 v : POSITION) : SV_Position { return v; }
[clipplanes(p)] float4 both(float4 v : POSITION) : SV_Position;
[clipplanes( p )] float4 both(float4 v : POSITION) : SV_Position { return v; }
// CHECK: gl_ClipDistance[0] = dot(in_POSITION0, planes.p);
