// Whole registers in order, however they are written.
// RUN: %clipc -T vs_4_0_level_9_1 -E main %s --table %t.json -o %t.vert
// RUN: FileCheck %s < %t.json
cbuffer Planes { float3 pad; float4 planes[2]; row_major float4x4 rows; float a, b; float2 cd; };
[clipplanes(planes[1].xyzw, rows[2], float4(a, b, cd), rows._m00_m01_m02_m03)]
float4 main(float4 v : POSITION) : SV_Position { return v; }
// CHECK: "byte_offset": 32
// CHECK: "byte_offset": 80
// CHECK: "byte_offset": 112
// CHECK: "byte_offset": 48
