// Thirty-two control points with matrices, bools and arrays, read before and after they are written.
// RUN: %draw compare %s -T hs_5_0 --random 40
// RUN: %draw compare %s -T hs_6_0 --target=glsl450,vulkan --seed 2 --random 40
struct P { row_major float3x3 m : M; bool on : ON; float2x4 c : C; int k[2] : K; };
struct C { float f[3] : SV_TessFactor; float i : SV_InsideTessFactor; bool any : ANY; row_major float2x3 r : R; };
C Fn(OutputPatch<P, 32> o, InputPatch<P, 32> p) {
  C c = (C)0;
  for (int i = 0; i < 3; ++i) c.f[i] = o[i * 7].m[1][i] + p[31 - i].c[1][2];
  c.i = o[31].on ? o[31].k[1] : p[3].m._m21;
  c.any = o[2].on || p[1].on;
  c.r = float2x3(o[3].m[0], p[4].m[2]);
  return c;
}
[domain("tri")] [partitioning("integer")] [outputtopology("triangle_cw")] [outputcontrolpoints(32)]
[patchconstantfunc("Fn")] P main(InputPatch<P, 32> p, uint i : SV_OutputControlPointID) {
  P v = p[i];
  v.m = mul(v.m, p[(i + 1) % 32].m);
  v.on = !v.on;
  return v;
}
