// saturate and rcp of a double are computed as doubles: `any_float` in DXC's gen_intrin_main.txt, and intrinsics.rcp.hlsl of its
// CodeGenSPIRV, "rcpd = rcp(d)"; floor, sqrt and their like are `float_like` there, which a double is narrowed to.
// RUN: %clipc %s -T vs_5_0 --validate -Wno-implicit-narrowing -o - | FileCheck %s
// RUN: %draw compare %s -T vs_5_0 --target=glsl450
// RUN: %draw compare %s -T vs_6_0 --target=vulkan
// CHECK: double saturate(double x) {
// CHECK-NEXT: return min(max(0.0lf, x), 1.0lf);  // 0 for NaN
float4 main(float4 n : N) : SV_Position {
  const double d = (double)n.x + n.y * 1e-12L;
  // CHECK: double s = saturate(d);
  const double s = saturate(d);
  // CHECK: dvec2 r = 1.0lf / dvec2(d + 3.0lf, s + 1.0lf);
  const double2 r = rcp(double2(d + 3, s + 1));
  const double2x2 m = saturate(double2x2(d, s, r));
  return float4((s - (float)s) * 1e9L, (r - (float2)r) * 1e9L, m[0][0] - m[1][1]);
}
