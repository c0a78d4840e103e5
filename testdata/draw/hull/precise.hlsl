// GLSL has no `precise` at the members of gl_out: what a precise position gets is a precise variable first.
// RUN: %clipc %s -T hs_5_0 --validate -o - | FileCheck %s
// RUN: %clipc %s -T hs_5_0 -DPLAIN -Gis --validate -o - | FileCheck %s
// RUN: %clipc %s -T hs_5_0 -DPLAIN --validate -o - | FileCheck %s --check-prefix=PLAIN --implicit-check-not=precise
// RUN: %clipc %s -T hs_5_0 -spirv -o %t.spv
// RUN: %draw compare %s -T hs_5_0 --target=glsl400,glsl450,vulkan
#ifdef PLAIN
#define precise
#endif
// CHECK: precise vec4 [[NAME:[a-z]+]] = {{.*}}gl_in[i].gl_Position * 2.0
// CHECK-NEXT: gl_out[gl_InvocationID].gl_Position = [[NAME]];
// PLAIN: gl_out[gl_InvocationID].gl_Position = {{.*}}gl_in[i].gl_Position * 2.0
struct V { float4 p : SV_Position; };
struct P { precise float4 p : SV_Position; };
struct C { float f[3] : SV_TessFactor; float i : SV_InsideTessFactor; };
float4 offset;
C Fn() { C c = {{1, 2, 3}, 1}; return c; }
[domain("tri")] [partitioning("integer")] [outputtopology("triangle_cw")] [outputcontrolpoints(3)] [patchconstantfunc("Fn")]
P main(InputPatch<V, 3> v, uint i : SV_OutputControlPointID) { P p = {v[i].p * 2 + offset}; return p; }
