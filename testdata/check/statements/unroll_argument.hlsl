// An argument of `unroll` that is not a whole number is warned of, and the attribute is ignored. Oracle: fxc X3554, as DXC's test
// attributes_Mod.hlsl cites it.
// RUN: %clipc -T vs_6_0 -fsyntax-only %s 2>&1 | FileCheck %s --implicit-check-not=warning:
float4 main(float4 p : POSITION) : SV_Position {
  float4 sum = 0;
  // CHECK: [[#@LINE+1]]:3: warning: attribute `unroll` takes a whole number; it is ignored [-Wattribute-argument]
  [unroll(1.5)] for (int i = 0; i < 3; ++i) sum += p;
  return sum;
}
