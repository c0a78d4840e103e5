// A patch is a constant array where the stage has no patches: vkd3d's patch-syntax.shader_test, checked against native.
// RUN: %clipc -T ps_5_0 %s --validate -o - | FileCheck %s
// RUN: %clipc -T ps_6_0 %s --validate -DNO_LOCALS -o - | FileCheck %s
// RUN: %draw compare %s -T ps_5_0
// CHECK: float points[2];
InputPatch<float, 2> points;
OutputPatch<float4, 64> many;
typedef InputPatch<float, 2> Pair;
float data[2];
float4 main() : SV_Target {
#ifndef NO_LOCALS
  Pair pair = data;
#else
  float pair[2] = data;
#endif
  return points[0] + points[1] * 2 + many[63] + pair[1];
}
