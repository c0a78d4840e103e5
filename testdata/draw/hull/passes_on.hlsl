// A function of the control points that gives nothing passes them on: fxc, not dxc (vkd3d's tessellation.shader_test).
// RUN: %clipc %s -T hs_5_0 --validate -o - | FileCheck %s
// RUN: %clipc %s -T hs_6_0 -o - 2>&1 | FileCheck %s --check-prefix=NEW
// RUN: %draw compare %s -T hs_5_0
// CHECK: gl_out[gl_InvocationID].gl_Position =
// CHECK: hs_UV0[gl_InvocationID] =
// NEW-NOT: gl_out
struct V { float4 p : SV_Position; float2 uv : UV; };
struct C { float f[3] : SV_TessFactor; float i : SV_InsideTessFactor; };
void Fn(InputPatch<V, 3> v, out C c) { c.f[0] = c.f[1] = c.f[2] = v[1].uv.x; c.i = 1; }
[domain("tri")] [partitioning("integer")] [outputtopology("triangle_cw")] [outputcontrolpoints(3)] [patchconstantfunc("Fn")]
void main(InputPatch<V, 3> v) {}
