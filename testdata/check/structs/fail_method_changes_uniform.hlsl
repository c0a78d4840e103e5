// A method cannot change a member of a constant buffer. Oracle: fxc X3025. A method that changes nothing,
// although its text does not show that, may be called.
// RUN: not %clipc -T vs_5_0 -fsyntax-only %s 2>&1 | FileCheck %s --implicit-check-not=error:
float twice(float x) { return 2 * x; }
void set(inout float x) { x = 3; }
struct Light {
  float4 color;
  float power;
  float scaled() { return twice(power); }
  void dim() { power *= 0.5; }
  void reset() { set(power); }
  void all() { dim(); }
};
cbuffer Lights {
  Light light, others[4];
};
float4 main(float4 p : POSITION, int i : I) : SV_Position {
  Light local = light;
  local.dim();
  // CHECK: [[#@LINE+1]]:9: error: `light` is set by the application; a shader cannot assign to it; `static` makes a variable of the shader's own [uniform-assigned, X3025]
  light.dim();
  // CHECK: [[#@LINE+1]]:13: error: `others` is set by the application
  others[i].reset();
  // CHECK: [[#@LINE+1]]:9: error: `light` is set by the application
  light.all();
  return p * light.scaled() * others[i].scaled() + local.power;
}
