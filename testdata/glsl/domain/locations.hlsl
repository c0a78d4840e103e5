// Drivers of OpenGL number the control points and the constants of a patch together, up to 31.
// RUN: %clipc %s -T ds_5_0 --tessellation=integer,triangle_cw -o %t.tese 2>&1 | FileCheck %s
// RUN: %clipc %s -T ds_5_0 --tessellation=integer,triangle_cw --target=vulkan -Werror -o %t.tese 2>&1 | count 0
// RUN: %clipc %s -DCOUNT=31 -T ds_5_0 --tessellation=integer,triangle_cw -Werror -o %t.tese 2>&1 | count 0
#ifndef COUNT
#define COUNT 32
#endif
struct P { float4 p[COUNT] : P; };
// CHECK: [[#@LINE+1]]:67: warning: `COLOR0` has location 32; drivers of target `glsl450` may have 0 to 31 only, for the control points and the constants of a patch together [-Wtarget-locations]
[domain("tri")] float4 main(const OutputPatch<P, 3> v, float4 c : COLOR) : SV_Position { return v[0].p[COUNT - 1] + c; }
