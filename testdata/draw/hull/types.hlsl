// A semantic has one input, whatever types the two functions give it: fxc has one signature for both. The wider type is the input's.
// RUN: %clipc %s -T hs_5_0 --validate -Werror -o - | FileCheck %s
// RUN: %clipc %s -T hs_5_0 -spirv -o %t.spv
// RUN: %draw compare %s -T hs_5_0 --target=glsl400,glsl410,glsl450,vulkan
// CHECK-COUNT-1: in vec4 vs_COLOR0[];
// CHECK-NOT: vs_COLOR0[];
// CHECK: in vec3 vs_NORMAL0[];
// CHECK-NOT: vs_NORMAL0[];
struct V { float2 c : COLOR; float3 n : NORMAL; uint k : K; };
struct W { float4 c : COLOR; float n : NORMAL; uint2 k : K; };
struct O { float3 c : COLOR; uint k : K; };
struct C { float f[3] : SV_TessFactor; float i : SV_InsideTessFactor; float3 sum : SUM; };
C Fn(InputPatch<W, 3> p) {
  C c;
  for (int i = 0; i < 3; ++i) c.f[i] = p[i].c.w + p[i].k.y;
  c.i = p[1].n;
  c.sum = p[2].c.xyz;
  return c;
}
[domain("tri")] [partitioning("integer")] [outputtopology("triangle_cw")] [outputcontrolpoints(3)] [patchconstantfunc("Fn")]
O main(InputPatch<V, 3> p, uint i : SV_OutputControlPointID) { O o = {float3(p[i].c, p[2].n.z), p[i].k}; return o; }
