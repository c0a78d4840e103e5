// A template is not the function of the constants of a patch; its specialisations have no name to give.
// RUN: not %clipc %s -T hs_6_0 -E hs 2>&1 | FileCheck %s
struct P { float4 p : SV_Position; };
struct C { float f[3] : SV_TessFactor; float i : SV_InsideTessFactor; };
template<typename T> C Cut(InputPatch<T, 3> patch) { return (C)1; }
// CHECK: [[#@LINE+1]]:{{[0-9]+}}: error: {{.*}}`Cut`{{.*}} [patch-function-missing
[domain("tri")] [partitioning("integer")] [outputtopology("triangle_cw")] [outputcontrolpoints(3)] [patchconstantfunc("Cut")]
P hs(InputPatch<P, 3> patch, uint i : SV_OutputControlPointID) { return patch[i]; }
