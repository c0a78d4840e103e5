// Under [earlydepthstencil] the depth goes nowhere, which a warning says. OpenGL ES refuses to assign to it, so that it is left out there.
// RUN: %clipc %s -T ps_5_0 --target=essl310 --validate -o - 2>&1 | FileCheck %s --check-prefixes=CHECK,ES --implicit-check-not=gl_FragDepth
// RUN: %clipc %s -T ps_5_0 --target=essl320 --validate -o - 2>&1 | FileCheck %s --check-prefixes=CHECK,ES --implicit-check-not=gl_FragDepth
// RUN: %clipc %s -T ps_5_0 --validate -o - 2>&1 | FileCheck %s --check-prefixes=CHECK,DESKTOP
// CHECK: [[#@LINE+2]]:47: warning: `SV_Depth` is not written; under `earlydepthstencil` depth is tested before the shader runs [-Wdepth-early-tests]
[earlydepthstencil]
float4 main(float2 uv : UV, out float depth : SV_Depth) : SV_Target {
  depth = uv.x;
  return depth;
}
// ES: SV_Target0 = vec4(
// DESKTOP: gl_FragDepth = 
