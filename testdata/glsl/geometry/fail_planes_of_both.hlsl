// Clip planes of the vertex shader and of the geometry shader: neither may be lost.
// RUN: not %clipc %s -E vs --geometry-entry=gs --geometry-output=%t.geom -o %t.vert --planes-in-last-stage 2>&1 | FileCheck %s
// RUN: not %clipc %s -T gs_5_0 -E gs --target=hlsl -o %t.hlsl 2>&1 | FileCheck %s --check-prefix=HLSL
float4 a, b;
struct V { float4 p : SV_Position; };
// CHECK: [[#@LINE+4]]:1: error: `clipplanes` is given twice; give all planes in one attribute [clip-planes-twice, X3524]
// CHECK: [[#@LINE+1]]:1: note: first given here
[clipplanes(a)] V vs(float4 p : POSITION) { V o = {p}; return o; }
// HLSL: [[#@LINE+1]]:1: error: `--target=hlsl` for the clip planes of a geometry shader is not supported [unsupported]
[clipplanes(b)] [maxvertexcount(1)] void gs(point V v[1], inout PointStream<V> s) { s.Append(v[0]); }
