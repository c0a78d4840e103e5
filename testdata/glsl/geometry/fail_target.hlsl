// Targets without geometry shaders name the nearest one that has them.
// RUN: not %clipc %s -T gs_4_0 --target=glsl140 2>&1 | FileCheck %s -DTARGET=glsl140 -DNEAR=glsl150
// RUN: not %clipc %s -T gs_5_0 --target=essl300 2>&1 | FileCheck %s -DTARGET=essl300 -DNEAR=essl310
// RUN: not %clipc %s -T gs_5_0 --target=webgl2 2>&1 | FileCheck %s -DTARGET=webgl2 -DNEAR=glsl150
// RUN: not %clipc %s -T gs_5_0 -E twice --target=glsl330 2>&1 | FileCheck %s --check-prefix=TWICE
// RUN: not %clipc %s -T gs_5_0 -E streams --target=essl320 2>&1 | FileCheck %s --check-prefix=STREAMS
// CHECK-NOT: error
// CHECK: [[#@LINE+3]]:6: error: `main` is a geometry shader; target `[[TARGET]]` has none [target-geometry-shader]
// CHECK: note: target `[[NEAR]]` can
[maxvertexcount(1)]
void main(point float4 p[1] : SV_Position, inout PointStream<float4> stream : SV_Position) { stream.Append(p[0]); }
// CHECK-NOT: error
// TWICE: error: the geometry shader has `instance`; target `glsl330` lacks it [target-emission]
// TWICE: note: target `glsl400` can
[instance(2)] [maxvertexcount(1)]
void twice(point float4 p[1] : SV_Position, inout PointStream<float4> stream : SV_Position) { stream.Append(p[0]); }
// STREAMS: error: the geometry shader has `two`; target `essl320` lacks it [target-emission]
// STREAMS: note: target `glsl400` can
[maxvertexcount(1)]
void streams(point float4 p[1] : SV_Position, inout PointStream<float4> one : SV_Position, inout PointStream<float4> two : A) {
  one.Append(p[0]);
  two.Append(p[0]);
}
