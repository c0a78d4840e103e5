// Clip distances of the control points, which both functions read.
// RUN: %draw compare %s -T hs_5_0 --target=glsl400,glsl410,glsl450,vulkan
struct V { float4 p : SV_Position; float3 clip : SV_ClipDistance; };
struct O { float4 p : SV_Position; float clip : SV_ClipDistance; };
struct C { float f[4] : SV_TessFactor; float i[2] : SV_InsideTessFactor; };
C Fn(InputPatch<V, 4> p) {
  C c;
  for (int i = 0; i < 4; ++i) c.f[i] = p[i].clip.z;
  c.i[0] = p[2].clip.x; c.i[1] = p[1].p.y;
  return c;
}
[domain("quad")] [partitioning("integer")] [outputtopology("triangle_cw")] [outputcontrolpoints(4)]
[patchconstantfunc("Fn")] O main(InputPatch<V, 4> p, uint i : SV_OutputControlPointID) { O o = {p[i].p, p[i].clip.x + p[3].clip.y}; return o; }
