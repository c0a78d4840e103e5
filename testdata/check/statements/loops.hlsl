// A loop that has one iteration or none, up to 5.1. Oracle: fxc X3557, "loop only executes for 1 iteration(s), forcing loop to unroll";
// with an attribute it is meant. dxc has no word about it.
// RUN: %clipc -T vs_5_0 -fsyntax-only %s 2>&1 | FileCheck %s --implicit-check-not=warning:
// RUN: %clipc -T vs_5_0 -fsyntax-only -Wno-loop-runs-once %s 2>&1 | count 0
// RUN: %clipc -T vs_6_0 -fsyntax-only %s 2>&1 | count 0
#define LIGHTS 1
cbuffer Lights {
  float4 lights[4];
};
float4 main(float4 p : POSITION, int n : N) : SV_Position {
  // CHECK: [[#@LINE+1]]:3: warning: the loop runs at most once; `[unroll]` says that this is meant [-Wloop-runs-once]
  for (int i = 0; i < LIGHTS; ++i) p += lights[i];
  // CHECK: [[#@LINE+1]]:3: warning: the loop runs at most once
  for (uint j = 0; j < 0; ++j) p += lights[j];
  [unroll] for (int k = 0; k < LIGHTS; ++k) p += lights[k];
  for (int l = 0; l < 2; ++l) p += lights[l];
  for (int m = 0; m < 1; ++m) { p += lights[m]; if (p.x > 0) m -= 1; }
  for (int o = 0; o < n; ++o) p += lights[o];
  return p;
}
