// An input of the pixel shader that nothing writes is an error by its semantic, and none of the files is written.
// RUN: rm -f %t.vert %t.frag
// RUN: not %clipc %s -E vs --pixel-entry=ps -o %t.vert --pixel-output=%t.frag 2>&1 | FileCheck %s --match-full-lines
// RUN: not ls %t.vert
// RUN: not ls %t.frag
// RUN: not %clipc %s -E vs --pixel-entry=ps --target=glsl330 -o %t.vert --pixel-output=%t.frag
// RUN: %clipc %s -E vs --pixel-entry=ps --zero-unwritten -w -o %t.vert --pixel-output=%t.frag
// RUN: FileCheck %s --check-prefix=ZERO --input-file=%t.vert
// ZERO: vs_TEXCOORD3 = vec2(0.0);
float4 vs(float4 position : POSITION) : SV_Position { return position; }
// CHECK: {{.*}}:[[#@LINE-1]]:8: error: the vertex shader writes nothing that matches the pixel shader's input `TEXCOORD3`; with `--zero-unwritten` it is 0 [pixel-input-unwritten]
float4 ps(float2 uv : TEXCOORD3) : SV_Target { return uv.xyxy; }
// CHECK: clipc: note: {{.*}}:[[#@LINE-1]]:23: the pixel shader's input `TEXCOORD3` is a `vec2`
