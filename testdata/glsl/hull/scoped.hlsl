// The function of the constants in a namespace, which nothing but the attribute names.
// RUN: %clipc %s -T hs_6_0 -E hs --validate -o - | FileCheck %s
struct P { float4 p : SV_Position; };
struct C { float f[3] : SV_TessFactor; float i : SV_InsideTessFactor; };
namespace patches {
C Cut() { C cuts = {{1, 2, 3}, 4}; return cuts; }
}
// CHECK: gl_TessLevelOuter[2] = 
[domain("tri")] [partitioning("integer")] [outputtopology("triangle_cw")] [outputcontrolpoints(3)] [patchconstantfunc("patches::Cut")]
P hs(InputPatch<P, 3> patch, uint i : SV_OutputControlPointID) { return patch[i]; }
