// A `const` local variable that GLSL does not take for a constant makes those that read it none either.
// RUN: %clipc -T vs_5_0 --target=glsl330 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=essl300 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=glsl450 --validate %s -o - | FileCheck %s
float4 main(float4 p : POSITION) : SV_Position {
  // CHECK: {{^}}    float infinity = uintBitsToFloat(0x7f800000u);
  const float infinity = 1.#INF;
  // CHECK-NEXT: {{^}}    float nan = infinity * 0.0;
  const float nan = infinity * 0.0;
  // CHECK-NEXT: {{^}}    const float one = 1.0;
  const float one = 1;
  return p.x < infinity ? p * one : nan;
}
