// State blocks of local variables, and values of the effects framework in an initialiser: vkd3d's state-block-syntax.shader_test, line 151, and
// effect-compile.shader_test, line 228, checked against fxc. They have no meaning for a shader.
// RUN: %clipc -T ps_5_0 %s --validate -o - | FileCheck %s
float4 Made(uniform float r) : SV_Target { return r; }
struct Apple { float4 f; PixelShader ps; };
Apple apple = { 1, 2, 3, 4, compile ps_4_0 Made(2 * 3) };
float4 list = { 1, 2, CompileShader(ps_4_0, Made(1)), 4 };
struct Filtered { float a; sampler s; } filtered = { 1, sampler_state { Filter = LINEAR; } };
float4 main() : SV_Target {
  float zero = 0;
  float a {};
  float b {
    foo = bar;
    foo = float4(bar, baz, 1, 2);
    foo = zero++;
  };
  float c {}, d = 1;
  struct { int a; } s { foo = bar; };
  // CHECK: SV_Target0 = vec4(0.0, d, zero, 1.0) + globals.list;
  return float4(0, d, zero, 1) + list;
}
