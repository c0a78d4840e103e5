// Integers of 64 bits come with shader model 6. Oracle: fxc X3653 of Microsoft's page of HLSL's errors, "doesn't support 64-bit
// integers"; the suffix `l` is of an int there.
// RUN: not %clipc -T vs_5_1 -fsyntax-only %s 2>&1 | FileCheck %s --implicit-check-not=error:
// RUN: %clipc -T vs_6_0 -fsyntax-only %s 2>&1 | count 0
// RUN: %clipc -T vs_5_1 -DONLY_SUFFIX %s | FileCheck %s --check-prefix=SUFFIX
cbuffer Numbers {
  int n;
};
float4 main(float4 p : POSITION) : SV_Position {
  // SUFFIX: int {{.*}}n + 3
  int suffixed = n + 3l;
#ifndef ONLY_SUFFIX
  // CHECK: [[#@LINE+1]]:3: error: `uint64_t` needs profile vs_6_0 or later; this is `vs_5_1` [type-profile, X3653]
  uint64_t a = n;
  // CHECK: [[#@LINE+1]]:10: error: `int64_t` needs profile vs_6_0 or later; this is `vs_5_1`
  vector<int64_t, 2> b = n;
#endif
  return p * suffixed;
}
