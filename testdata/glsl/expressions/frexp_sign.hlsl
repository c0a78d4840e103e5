// The mantissa of frexp is positive: fxc and DXC mask the sign away.
// RUN: %clipc -T vs_5_0 %s --validate -o - | FileCheck %s
// RUN: %draw compare %s -T vs_5_0 --target=glsl450
// CHECK: uintBitsToFloat((bits & 0x007FFFFFu) | 0x3F000000u);
float4 main(float4 p : POSITION) : SV_Position {
  float exponent;
  float mantissa = frexp(-abs(p.x), exponent);
  return float4(mantissa, exponent, p.zw);
}
