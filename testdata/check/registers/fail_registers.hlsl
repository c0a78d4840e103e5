// RUN: not %clipc -T vs_5_0 -E twice %s 2>&1 | FileCheck %s --check-prefix=TWICE
// RUN: not %clipc -T vs_5_0 -E high %s 2>&1 | FileCheck %s --check-prefix=HIGH
cbuffer A : register(b1) { float4 a; };
cbuffer B : register(b1) { float4 b; };
// TWICE: error: `A` and `B` are both bound to register b1; each needs its own [register-twice, X4500]
// TWICE: note: `A` is declared here
float4 twice(float4 v : POSITION) : SV_Position { return a + b; }
// HIGH: error: register b14 of `C` is too high; the highest under this profile is 13 [register-too-high, X4567]
cbuffer C : register(b14) { float4 c; };
float4 high(float4 v : POSITION) : SV_Position { return c; }
