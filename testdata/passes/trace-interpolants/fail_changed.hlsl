// A parameter with two inputs, and a variable that is written a second time, are not an input.
// RUN: not %clipc -T ps_6_1 %s 2>&1 | FileCheck %s
// RUN: not %clipc -T ps_6_1 -E twice %s 2>&1 | FileCheck %s --check-prefix=TWICE
// CHECK: [[#@LINE+1]]:36: error: `EvaluateAttributeAtSample` is given a value that is not an input of the shader, unchanged, or components of one; GLSL evaluates inputs only [interpolant-not-input]
float2 AtSample(float2 x) { return EvaluateAttributeAtSample(x, 1); }
float4 main(float2 a : A, float2 b : B) : SV_Target { return float4(AtSample(a), AtSample(b)); }

float4 twice(float2 a : A, float2 b : B) : SV_Target {
  float2 place = a;
  if (b.x > 2)
    place = b;
  // TWICE: [[#@LINE+1]]:10: error: `EvaluateAttributeAtSample` is given a value
  return EvaluateAttributeAtSample(place, 1).xyxy;
}
