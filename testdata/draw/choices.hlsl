// The sides of ?: say whether it gives a vector or a matrix of one row (vkd3d's test of the operator, checked against native).
// RUN: %draw compare %s -T vs_5_0 --target=glsl450,glsl330,vulkan
// RUN: %clipc -T vs_5_0 %s | FileCheck %s
struct Output {
  float4 position : SV_Position;
  float4 row : ROW;
  float component : COMPONENT;
};
Output main(float4 p : POSITION) {
  Output o;
  o.position = p;
  float1x4 a = p * 2, b = p.wzyx;
  // CHECK: vs_ROW0 = mix(
  o.row = (p > 0 ? a : b)[0];
  o.component = (a > 0 ? p : p.wzyx)[0];
  return o;
}
