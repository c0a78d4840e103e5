// A comparison sampler compares floats, in GatherCmp too; what nothing reads is left out.
// RUN: not %clipc %s -T ps_6_0 2>&1 | FileCheck %s
// RUN: %clipc %s -T ps_6_0 -E unread -o - | FileCheck %s --check-prefix=UNREAD --implicit-check-not=Gather
// UNREAD: SV_Target0 = 
Texture2D<uint> t;
SamplerComparisonState s;
uint4 main(float2 l : A) : SV_Target {
  uint status;
  // CHECK: [[#@LINE+2]]:10: error: `GatherCmp` is called on a `Texture2D<uint>`; a sampler compares floats only; `Load` reads integers [method-of-integers
  // CHECK: [[#@LINE+1]]:50: error: `GatherCmp` is called on a `Texture2D<uint>`; a sampler compares floats only
  return t.GatherCmpRed(s, l, 0.5, int2(1, 2)) + t.GatherCmp(s, l, 0.5, int2(1, 2), status);
}
uint4 unread(float2 l : A) : SV_Target {
  uint4 value = t.GatherCmpRed(s, l, 0.5);
  return 1;
}
