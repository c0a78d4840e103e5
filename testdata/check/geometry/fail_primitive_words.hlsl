// The words for a primitive belong at parameters of a geometry shader (vkd3d's geometry-shader-syntax.shader_test).
// RUN: not %clipc %s -T gs_5_0 -E gs 2>&1 | FileCheck %s
// RUN: %clipc %s -T ps_5_0 -E ps -D PIXEL -o %t.frag 2>&1 | FileCheck %s --check-prefix=PIXEL
struct V { float4 p : SV_Position; };
#ifndef PIXEL
// CHECK: [[#@LINE+1]]:13: error: a global variable cannot be `line` [qualifier-misplaced, X3006]
line float4 x[2];
// CHECK: error: a field cannot be `triangle` [qualifier-misplaced, X3006]
struct S { triangle float4 v[3]; };
[maxvertexcount(1)] void gs(point V v[1], inout PointStream<V> o) { o.Append(v[0]); }
#else
// PIXEL: warning: `point` has no effect on a parameter of a pixel shader; fxc reports an error [-Wqualifier-without-effect]
float4 ps(point float4 v[1] : COLOR) : SV_Target { return v[0]; }
#endif
