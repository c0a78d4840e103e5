// What the host asks for in a block with an instance name, in one without, and outside blocks.
// RUN: %clipc -T vs_5_0 --reflect=%t.json %s -o %t.vert
// RUN: FileCheck %s --input-file=%t.json
// RUN: %clipc -T vs_5_0 --blocks=plain --reflect=%t.json %s -o %t.vert
// RUN: FileCheck %s --check-prefix=PLAIN --input-file=%t.json
// RUN: %clipc -T vs_5_0 --blocks=flat --reflect=%t.json %s -o %t.vert
// RUN: FileCheck %s --check-prefix=FLAT --input-file=%t.json
// RUN: %clipc -T vs_5_0 --dump=table %s | FileCheck %s --check-prefix=TABLE
cbuffer PerFrame { float4x4 view; float4 planes[2]; };

[clipplanes(planes[1])]
float4 main(float4 p : POSITION) : SV_Position { return mul(p, view); }

// CHECK: "layout": "std140",
// CHECK-NEXT: "block": "PerFrame",
// CHECK-NEXT: "instance": "perFrame",
// CHECK: "glsl": "PerFrame.view"
// PLAIN: "block": "PerFrame",
// PLAIN-NOT: "instance"
// PLAIN: "glsl": "view"
// FLAT: "layout": "uniforms"
// FLAT: "glsl": "view",
// FLAT-NEXT: "transpose": true
// TABLE: "glsl_block":{{ *}}"PerFrame"
// TABLE: "glsl_member":{{ *}}"PerFrame.planes[1]"
