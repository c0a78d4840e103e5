// Planes put together from several constants are allowed where planes become clip distances (fxc: X4594 on 9_x only).
// RUN: %clipc -T vs_4_0 -E main --validate %s -o - | FileCheck %s
cbuffer Planes { float4x4 m; float a; float b; float2 cd; float3 abc; float f; };

[clipplanes(f.xxxx, m[0], float4(a, b, cd), float4(abc, f), m._m00_m10_m20_m30)]
float4 main(float4 v : POSITION) : SV_Position { return v; }
// CHECK: gl_ClipDistance[0] = dot(in_POSITION0, vec4(planes.f));
// CHECK: gl_ClipDistance[1] = dot(in_POSITION0, planes.m[0]);
// CHECK: gl_ClipDistance[2] = dot(in_POSITION0, vec4(planes.a, planes.b, planes.cd));
// CHECK: gl_ClipDistance[3] = dot(in_POSITION0, vec4(planes.abc, planes.f));
// CHECK: gl_ClipDistance[4] = dot(in_POSITION0, vec4(planes.m[0][0], planes.m[1][0], planes.m[2][0], planes.m[3][0]));
