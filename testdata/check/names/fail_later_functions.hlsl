// A function is declared before it is called. Oracles: fxc X3004; vkd3d's function.shader_test, which fails natively in every profile.
// RUN: not %clipc -T vs_5_0 -fsyntax-only %s 2>&1 | FileCheck %s --implicit-check-not=error:
// RUN: not %clipc -T vs_6_0 -fsyntax-only %s 2>&1 | FileCheck %s --implicit-check-not=error:
float4 prototype(float4 p);
struct S {
  float4 first(float4 p) { return second(p); }
  float4 second(float4 p) { return p; }
};
float4 main(float4 p : POSITION) : SV_Position {
  S s;
  // CHECK: [[#@LINE+2]]:10: error: `later` is called before it is declared; declare it first, or move it up [called-before-declared, X3004]
  // CHECK: [[#@LINE+4]]:8: note: `later` is declared here
  return later(p) + prototype(p) + s.first(p) + lerp(p, p, p);
}
float4 prototype(float4 p) { return p; }
float4 later(float4 p) { return p; }
// An intrinsic is called where the function of its name comes later.
float4 lerp(float4 a, float4 b, float4 c) { return 0; }
