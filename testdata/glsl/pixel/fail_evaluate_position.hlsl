// GLSL interpolates what the shader before writes, and not gl_FragCoord.
// RUN: not %clipc %s -T ps_5_0 2>&1 | FileCheck %s
float4 main(float4 a : SV_Position) : SV_Target {
  // CHECK: [[#@LINE+1]]:10: error: `EvaluateAttributeCentroid` is given a value that is not an input of the shader, unchanged, or components of one; GLSL evaluates inputs only [interpolant-not-input]
  return EvaluateAttributeCentroid(a.yxzw);
}
