// A float divided by 0, up to 5.1. Oracle: fxc X4008, "floating point division by zero"; dxc has no word about it.
// RUN: %clipc -T vs_5_0 -fsyntax-only %s 2>&1 | FileCheck %s --implicit-check-not=warning:
// RUN: %clipc -T vs_5_0 -fsyntax-only -Wno-division-by-zero %s 2>&1 | count 0
// RUN: %clipc -T vs_6_0 -fsyntax-only %s 2>&1 | count 0
float4 main(float4 p : POSITION) : SV_Position {
  // CHECK: [[#@LINE+1]]:19: warning: a float is divided by 0; the result is infinity or NaN [-Wdivision-by-zero]
  float a = p.x / 0;
  // CHECK: [[#@LINE+1]]:21: warning: a float is divided by 0
  float2 b = p.xy / float2(1, 0);
  // CHECK: [[#@LINE+1]]:8: warning: a float is divided by 0
  p /= 0.0;
  float c = 0 / p.z + p.y / 1;
  return p + a + b.xyxy + c;
}
