// A path of main that does not write the depth has the primitive's; GLSL leaves gl_FragDepth undefined there. (One of a function of its own,
// which an entry with several returns becomes, leaves it undefined as HLSL does.)
// RUN: %clipc %s -T ps_5_0 -E some -w --validate -o - | FileCheck %s
// RUN: %clipc %s -T ps_5_0 -E some -w --target=essl100 --validate -o - | FileCheck %s --check-prefix=OLD
// RUN: %clipc %s -T ps_5_0 -E every --validate -o - | FileCheck %s --check-prefix=EVERY --implicit-check-not=gl_FragCoord.z
// CHECK: void main() {
// CHECK-NEXT: gl_FragDepth = gl_FragCoord.z;
// CHECK-NEXT: if (vs_UV0.x > 0.5) {
// OLD: gl_FragDepthEXT = gl_FragCoord.z;
float4 some(float2 uv : UV, out float depth : SV_DepthGreaterEqual) : SV_Target {
  if (uv.x > 0.5) depth = 1;
  return 0;
}
// EVERY: gl_FragDepth = 1.0;
float4 every(float2 uv : UV, out float depth : SV_Depth) : SV_Target {
  depth = 1;
  if (uv.x > 0.5) depth = 0.5;
  return 0;
}
