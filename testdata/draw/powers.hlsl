// pow with an exponent that is a known whole number is a product where fxc and dxc multiply, so a negative base has its power:
// CanUseFxcMulOnlyPatternForPow and TranslatePowImpl in DXC's HLOperationLower.cpp.
// RUN: %clipc -T vs_5_0 %s --validate | FileCheck %s
// RUN: %clipc -T vs_6_0 %s --validate | FileCheck %s --check-prefix=DXC
// RUN: %draw compare %s -T vs_5_0 --target=glsl450,glsl140,essl310,vulkan
// RUN: %draw compare %s -T vs_6_0 -E dxc --target=glsl450,vulkan
// CHECK: vec4 pow2(vec4 x) {
// CHECK-NEXT: return x * x;
// CHECK: float pow5(float x) {
// CHECK-NEXT: float x2 = x * x;
// CHECK-NEXT: return x * (x2 * x2);
// CHECK: vec4 pow7(vec4 x) {
// CHECK-NEXT: vec4 x2 = x * x;
static const float five = 5;
float4 main(float4 p : P, uint id : SV_VertexID) : SV_Position {
  float4 sum = pow(p - 0.5, 2) + pow(p, 2) + pow(-p, 3) * pow(p.xxxx, float4(4, 4, 4, 4));
  sum.x += pow(p.y - p.x, five) + pow(p.z, 0) + pow(p.w, 1) + pow(p.x, 8);
  // CHECK: 1.0 / (in_P0.y * in_P0.y)
  sum.y += pow(p.y, -2);
  sum += pow(p.wzyx * 0.5, 7);
  // Too many products for a scalar.
  // CHECK: pow(abs(in_P0.x), 7.0)
  sum.z += pow(abs(p.x), 7) + pow(abs(p.y), 0.5) + pow(abs(p.z), id);
  return sum;
}
// DXC: pow2(in_P0 - 0.5) + in_P0 * in_P0 + pow(
float4 dxc(float4 p : P) : SV_Position { return pow(p - 0.5, 2) + pow(p, 2) + pow(abs(p), 3); }
