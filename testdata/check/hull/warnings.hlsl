// What a hull shader gives and nothing takes is named.
// RUN: %clipc %s -T hs_5_0 --validate -o %t.tesc 2>&1 | FileCheck %s
// RUN: FileCheck %s --check-prefix=GLSL < %t.tesc
struct P { float4 p : POSITION; };
struct C {
  // CHECK: [[#@LINE+1]]:16: warning: element 2 of `SV_TessFactor` has no effect: domain `isoline` has 2 [-Wtess-factor-unused]
  float f[4] : SV_TessFactor;
  // CHECK: [[#@LINE+1]]:13: warning: element 0 of `SV_InsideTessFactor` has no effect: domain `isoline` has 0 [-Wtess-factor-unused]
  float i : SV_InsideTessFactor;
};
C Constants() { return (C)1; }
// GLSL: gl_TessLevelOuter[1] =
// GLSL-NOT: gl_TessLevel
[domain("isoline")] [partitioning("integer")] [outputtopology("line")] [outputcontrolpoints(1)]
[patchconstantfunc("Constants")] P main(InputPatch<P, 1> patch) { return patch[0]; }
