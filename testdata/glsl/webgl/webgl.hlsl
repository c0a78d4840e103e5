// WebGL 2 is OpenGL ES 3.00 with clip distances by the extension that browsers have (WEBGL_clip_cull_distance), and with
// names of its own.
// RUN: %clipc -T vs_5_0 --target=webgl2 %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=webgl2 --lower=discard --validate %s -o %t.vert
// RUN: FileCheck %s --input-file=%t.vert --check-prefix=DISCARD

// CHECK: #version 300 es
// CHECK-NEXT: #extension GL_ANGLE_clip_cull_distance : require
// CHECK: mat4 x_webgl_matrix;
// CHECK: out highp float gl_ClipDistance[1];
// CHECK: gl_ClipDistance[0] = dot(
// DISCARD: #version 300 es
// DISCARD-NOT: #extension
// DISCARD: mat4 x_webgl_matrix;
cbuffer C {
  float4x4 _webgl_matrix;
  float4 plane;
};
[clipplanes(plane)] float4 main(float4 p : POSITION) : SV_Position { return mul(p, _webgl_matrix); }
