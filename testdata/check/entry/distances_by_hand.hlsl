// SV_ClipDistance in any shape becomes one array, packed by register as fxc does: what straddles goes to the next four.
// RUN: %clipc -T vs_5_0 -E scalar --validate %s -o - | FileCheck %s --check-prefix=SCALAR
// RUN: %clipc -T vs_5_0 -E two_float3 --validate %s -o - | FileCheck %s --check-prefix=THREE
// RUN: %clipc -T vs_5_0 -E mixed --validate %s -o - | FileCheck %s --check-prefix=MIXED
// RUN: %clipc -T vs_5_0 -E several --validate %s -o - | FileCheck %s --check-prefix=SEVERAL
cbuffer C { float4 p, q; };
// SCALAR: gl_ClipDistance[1]
void scalar(float4 v : POSITION, out float4 o : SV_Position, out float d : SV_ClipDistance) { o = v; d = dot(v, p); }
// SCALAR: gl_ClipDistance[0] = d;

struct Two { float4 position : SV_Position; float3 a : SV_ClipDistance0; float3 b : SV_ClipDistance1; };
Two two_float3(float4 v : POSITION) { Two o; o.position = v; o.a = p.xyz; o.b = q.xyz; return o; }
// THREE: gl_ClipDistance[7]
// THREE: gl_ClipDistance[2] = a.z;
// THREE: gl_ClipDistance[3] = 0.0;
// THREE: gl_ClipDistance[4] = b.x;
// THREE: gl_ClipDistance[6] = b.z;

struct Mixed { float4 position : SV_Position; float3 a : SV_ClipDistance0; float b : SV_ClipDistance1; float2 c : SV_CullDistance; };
Mixed mixed(float4 v : POSITION) { Mixed o; o.position = v; o.a = p.xyz; o.b = q.x; o.c = q.yz; return o; }
// MIXED-DAG: gl_ClipDistance[3] = b;
// MIXED-DAG: gl_CullDistance[1] = c_2.y;

float4 several(float4 v : POSITION, out float2 b : SV_ClipDistance1, out float4 d[1] : SV_ClipDistance0) : SV_Position {
  b = q.xy;
  d[0] = p;
  return v;
}
// SEVERAL: gl_ClipDistance[6]
// SEVERAL: gl_ClipDistance[3] = d[0].w;
// SEVERAL: gl_ClipDistance[4] = b.x;
