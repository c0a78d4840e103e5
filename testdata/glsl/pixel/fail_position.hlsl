// ES has its origin in the lower left corner (OpenGL ES 3.2, 15.1.2), Direct3D in the upper left one.
// RUN: not %clipc -T ps_5_0 --target=essl310 %s -o - 2>&1 | FileCheck %s
float4 main(float4 position : SV_Position) : SV_Target { return position.y; }
// CHECK: [[#@LINE-1]]:31: error: `SV_Position.y` counts from the upper edge; target `essl310` counts from the lower one; pass `--flip-y`, under which the picture is upside down, or take a target from `glsl150` on [target-origin]
