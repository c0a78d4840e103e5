// The functions that round tessellation factors are of hull shaders, which clipc does not translate.
// RUN: not %clipc %s -T hs_5_0 2>&1 | FileCheck %s
// CHECK: [[#@LINE+8]]:3: error: `ProcessTriTessFactorsMax` is not supported by clipc [intrinsic-unsupported]
struct P { float4 p : POSITION; };
struct C { float3 f : FACTORS; float e[3] : SV_TessFactor; float i : SV_InsideTessFactor; };
C Constants(InputPatch<P, 3> patch) {
  C c = (C)1;
  float3 edges;
  float inside, raw;
  c.f = patch[0].p.xyz;
  ProcessTriTessFactorsMax(c.f, 1, edges, inside, raw);
  return c;
}
[domain("tri")] [partitioning("integer")] [outputtopology("triangle_cw")] [outputcontrolpoints(3)]
[patchconstantfunc("Constants")] P main(InputPatch<P, 3> patch, uint i : SV_OutputControlPointID) { return patch[i]; }
