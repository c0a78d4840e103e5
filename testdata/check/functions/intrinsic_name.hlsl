// From 6.0 on a function with an intrinsic's name is called where the intrinsic does not take the arguments, even if one of them is
// spread: DXC has both among its candidates.
// RUN: %clipc -T ps_6_0 %s -o - | FileCheck %s
// RUN: %clipc -T ps_5_0 %s -o - | FileCheck %s
// RUN: %draw compare %s -T ps_6_0
struct S {
  float4 a;
};
float4 tex2D(S x, float2 v) { return x.a + v.xyxy; }
float4 main(float4 p : P) : SV_Target {
  S s;
  s.a = p;
  // CHECK: tex2D(s, vec2(1.0))
  return tex2D(s, 1);
}
