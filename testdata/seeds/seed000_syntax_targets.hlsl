// "User clip planes on feature level 9 hardware", Syntax: available for every vertex shader target from 4.0 on, level_9_1 and
// level_9_3 among them.
// RUN: %clipc -T vs_4_0 %s --validate -o - | FileCheck %s --check-prefix=DISTANCE
// RUN: %clipc -T vs_4_1 %s --validate -o - | FileCheck %s --check-prefix=DISTANCE
// RUN: %clipc -T vs_5_0 %s --validate -o - | FileCheck %s --check-prefix=DISTANCE
// RUN: %clipc -T vs_5_1 %s --validate -o - | FileCheck %s --check-prefix=DISTANCE
// RUN: %clipc -T vs_6_0 %s --validate -o - | FileCheck %s --check-prefix=DISTANCE
// RUN: %clipc -T vs_6_8 %s --validate -o - | FileCheck %s --check-prefix=DISTANCE
// RUN: %clipc -T vs_4_0_level_9_0 %s --table=%t.0.json -o /dev/null
// RUN: FileCheck %s --check-prefix=TABLE < %t.0.json
// RUN: %clipc -T vs_4_0_level_9_1 %s --table=%t.1.json -o /dev/null
// RUN: FileCheck %s --check-prefix=TABLE < %t.1.json
// RUN: %clipc -T vs_4_0_level_9_3 %s --table=%t.3.json -o /dev/null
// RUN: FileCheck %s --check-prefix=TABLE < %t.3.json

cbuffer Clip { float4 plane; };

// DISTANCE: gl_ClipDistance[0] = dot(in_POSITION0, clip.plane);
// TABLE: "lowering": "level9"
// TABLE: "text": "plane"
[clipplanes(plane)]
float4 main(float4 position : POSITION) : SV_Position { return position; }
