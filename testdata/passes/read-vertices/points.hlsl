// In a hull shader the control points of the patch are read as inputs, and those that are written as outputs, in both
// functions; one that passes on as a whole is made of them. A patch that goes to a function stays an array.
// RUN: %clipc %s -T hs_5_0 -E main --dump-after=read-vertices | FileCheck %s --check-prefix=DUMP
// RUN: %clipc %s -T hs_5_0 -E main --validate -o - | FileCheck %s --check-prefix=GLSL
// RUN: %clipc %s -T hs_5_0 -E passed --validate -o - | FileCheck %s --check-prefix=PASSED
// RUN: %draw compare %s -T hs_5_0 -E main
// RUN: %draw compare %s -T hs_5_0 -E passed
struct P {
  float4 p : POSITION;
  float2 uv[2] : TEXCOORD;
  int unread : N;
};
struct C {
  float f[3] : SV_TessFactor;
  float i : SV_InsideTessFactor;
};
// DUMP-NOT: local P[3]
// DUMP: input of vertex
// DUMP: end points
// DUMP: is first point
// DUMP: output of point
// GLSL: P result = P(vs_POSITION0[i], vec2[2](vs_TEXCOORD0[i], vs_TEXCOORD1[i]), vs_N0[i]);
// GLSL: hs_TEXCOORD1[k].x
C Constants(InputPatch<P, 3> patch, OutputPatch<P, 3> points, uint unread : SV_PrimitiveID) {
  C c;
  for (int k = 0; k < 3; ++k) c.f[k] = patch[k].p.w + points[k].uv[1].x;
  c.i = 2;
  return c;
}
// PASSED: P patch_[3];
// PASSED: Middle(patch_)
P Middle(InputPatch<P, 3> patch) {
  P p = patch[0];
  p.p += patch[1].p + patch[2].p;
  return p;
}
[domain("tri")] [partitioning("integer")] [outputtopology("triangle_cw")] [outputcontrolpoints(3)]
[patchconstantfunc("Constants")]
P main(InputPatch<P, 3> patch, uint i : SV_OutputControlPointID) { return patch[i]; }
[domain("tri")] [partitioning("integer")] [outputtopology("triangle_cw")] [outputcontrolpoints(3)]
[patchconstantfunc("Constants")]
P passed(InputPatch<P, 3> patch, uint i : SV_OutputControlPointID) { return Middle(patch); }
