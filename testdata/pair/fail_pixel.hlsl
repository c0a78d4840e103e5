// An error in the pixel shader is reported at its place, with those of the vertex shader, and none of the files is written.
// RUN: rm -f %t.vert %t.frag
// RUN: not %clipc %s -E vs --pixel-entry=ps -o %t.vert --pixel-output=%t.frag 2>&1 | FileCheck %s --match-full-lines
// RUN: not ls %t.vert
// RUN: not ls %t.frag
float4 vs(float4 position : POSITION) : SV_Position { return missing; }
// CHECK: {{.*}}:[[#@LINE-1]]:62: error: {{.*}}`missing`{{.*}}
float4 ps() : SV_Target { return absent; }
// CHECK: {{.*}}:[[#@LINE-1]]:34: error: {{.*}}`absent`{{.*}}
// RUN: not %clipc %s -E vs --pixel-entry=ps --pixel-profile=vs_5_0 -o %t.vert --pixel-output=%t.frag 2>&1 | FileCheck %s --check-prefix=PROFILE --implicit-check-not=pixel-bindings
// PROFILE: error: unknown profile `vs_5_0` of a pixel shader; `--pixel-profile` takes one such as `ps_5_0`
// RUN: not %clipc %s -E vs -o %t.vert --pixel-output=%t.frag 2>&1 | FileCheck %s --check-prefix=ENTRY
// ENTRY: --pixel-output needs --pixel-entry, the pixel shader's function in the same file
// RUN: not %clipc %s -E vs --pixel-entry=ps -T ps_5_0 -o %t.vert --pixel-output=%t.frag 2>&1 | FileCheck %s --check-prefix=STAGE
// STAGE: error: `--pixel-shader` is about a vertex shader; profile `ps_5_0` is of a pixel shader
