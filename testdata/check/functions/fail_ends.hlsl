// A call that reaches the end of a function for sure is an error, and so is one without constants that may reach it. From 6.0 on the
// function alone counts: dxc's -Wreturn-type is an error, and knows no constants of calls.
// RUN: not %clipc -T vs_5_0 -fsyntax-only %s 2>&1 | FileCheck %s --implicit-check-not=error:
// RUN: not %clipc -T vs_6_0 -fsyntax-only %s 2>&1 | FileCheck %s --check-prefixes=CHECK,DXC --implicit-check-not=error:
// RUN: not %clipc -T vs_5_0 -DNOTHING -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=NOTHING --implicit-check-not=error:
// CHECK-DAG: [[#@LINE+1]]:8: error: not every path through `fog` returns a value; its type is `float3` [not-all-paths-return, X3507]
float3 fog(float3 c, const int kind) { if (kind == 0) return c * 0.5; else if (kind == 1) return c; }
// CHECK-DAG: [[#@LINE+1]]:7: error: not every path through `unknown` returns
float unknown(float x, int kind) { if (kind == 0) return x; }
// DXC-DAG: [[#@LINE+1]]:7: error: not every path through `known` returns
float known(float x, int kind) { if (kind == 0) return x; }
#ifdef NOTHING
// NOTHING: [[#@LINE+1]]:7: error: not every path through `nothing` returns
float nothing(float x, int kind) { if (kind == 0) x = 3; }
#else
float nothing(float x, int kind) { return x; }
#endif
float4 main(float4 p : POSITION, int k : K) : SV_Position {
  return p.x + fog(p.xyz, 2).x + unknown(p.x, k) + known(p.x, 0) + nothing(p.x, 0);
}
