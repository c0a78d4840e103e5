// What a stage reads of each vertex is written by the stage before it, and clip distances that never clip are kept for a stage that reads them.
// RUN: not %clipc %s -E plain --geometry-entry=gs -o %t.vert --geometry-output=%t.geom 2>&1 | FileCheck %s
// RUN: not %clipc %s -E few --geometry-entry=gs -o %t.vert --geometry-output=%t.geom 2>&1 | FileCheck %s --check-prefix=FEW
// RUN: not %clipc %s -E few --pixel-entry=ps -o %t.vert --pixel-output=%t.frag 2>&1 | FileCheck %s --check-prefix=PIXEL
// RUN: not %clipc %s -E few --pixel-entry=other -o %t.vert --pixel-output=%t.frag 2>&1 | FileCheck %s --check-prefix=OTHER
// RUN: %clipc %s -E idle --geometry-entry=gs -o %t.vert --geometry-output=%t.geom --validate 2>&1 | count 0
// RUN: FileCheck %s --check-prefix=IDLE < %t.vert
struct Few { float4 p : SV_Position; float2 c : SV_ClipDistance; };
struct All { float4 p : SV_Position; float3 c : SV_ClipDistance; };
// CHECK: [[#@LINE+2]]:8: error: the vertex shader does not write `SV_Position`, which the geometry shader reads [builtin-unwritten]
// CHECK: [[#@LINE+1]]:8: error: the vertex shader does not write `SV_ClipDistance`, which the geometry shader reads [builtin-unwritten]
float4 plain(float4 p : POSITION) : COLOR { return p; }
// FEW: [[#@LINE+3]]:5: error: the vertex shader does not write component 2 of `SV_ClipDistance`, which the geometry shader reads
// PIXEL: [[#@LINE+2]]:5: error: the vertex shader does not write component 2 of `SV_ClipDistance`, which the pixel shader reads
// OTHER: [[#@LINE+1]]:5: error: the vertex shader does not write `SV_ClipDistance3`, which the pixel shader reads [builtin-unwritten]
Few few(float4 p : POSITION) { Few o = {p, p.xy}; return o; }
// IDLE: gl_ClipDistance[2] = 
All idle(float4 p : POSITION) { All o = {p, 1, 2, 3}; return o; }
[maxvertexcount(1)] void gs(point All v[1], inout PointStream<All> s) {
  All o = v[0];
  o.c -= o.p.xyz;
  s.Append(o);
}
float4 ps(All i) : SV_Target { return i.c.xyzz; }
float4 other(float2 c : SV_ClipDistance3) : SV_Target { return c.xyxy; }
