// Clip distances that the control points write, which the function of the constants reads.
// RUN: %clipc %s -T hs_5_0 --validate -o - | FileCheck %s
// RUN: %clipc %s -T hs_5_0 -spirv -o %t.spv
// RUN: %draw compare %s -T hs_5_0 --target=glsl400,glsl410,glsl450,vulkan
// CHECK: gl_out[1].gl_ClipDistance[2]
struct P { float4 p : SV_Position; float2 n : N; };
struct O { float4 p : SV_Position; float3 clip : SV_ClipDistance; };
struct C { float f[4] : SV_TessFactor; float i[2] : SV_InsideTessFactor; };
C Fn(OutputPatch<O, 4> p) {
  C c;
  for (int i = 0; i < 4; ++i) c.f[i] = p[i].clip.y;
  c.i[0] = p[1].clip.z; c.i[1] = p[3].p.y;
  return c;
}
[domain("quad")] [partitioning("integer")] [outputtopology("triangle_cw")] [outputcontrolpoints(4)]
[patchconstantfunc("Fn")] O main(InputPatch<P, 4> p, uint i : SV_OutputControlPointID) {
  O o = {p[i].p, float3(p[i].n, p[3].n.x)};
  return o;
}
