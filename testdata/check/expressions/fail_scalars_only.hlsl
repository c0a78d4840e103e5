// `&&`, `||` and `?:` of HLSL 2021 take scalars. Oracles: DXC's err_hlsl_logical_binop_scalar and err_hlsl_ternary_scalar; vkd3d's
// sm6-ternary.shader_test. `-HV 2018` and the profiles up to 5.1 take vectors.
// RUN: not %clipc -T vs_6_0 -fsyntax-only %s 2>&1 | FileCheck %s
// RUN: %clipc -T vs_6_0 -HV 2018 -fsyntax-only %s 2>&1 | count 0
// RUN: %clipc -T vs_5_0 -fsyntax-only %s 2>&1 | count 0
float4 main(float4 p : POSITION, float4 q : Q) : SV_Position {
  // CHECK: [[#@LINE+1]]:19: error: `&&` is applied to a `bool4`; it needs scalars from HLSL 2021 on; `and(a, b)` accepts vectors [needs-scalars]
  bool4 a = p > q && q > 0;
  // CHECK: [[#@LINE+1]]:21: error: `||` is applied to a `float4`; it needs scalars from HLSL 2021 on; `or(a, b)` accepts vectors
  bool4 b = p.x > 0 || q;
  // CHECK: [[#@LINE+1]]:14: error: `?:` is applied to a `bool4`; it needs scalars from HLSL 2021 on; `select(condition, a, b)` accepts vectors
  float4 c = p > q ? p : q;
  a &= b;
  return c * (p.x > 0 && q.x > 0 ? a : b);
}
