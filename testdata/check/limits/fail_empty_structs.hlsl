// Structs of empty structs have no size, and each still doubles the time of a walk over the one that holds it.
// RUN: not %clipc -T vs_5_0 %s 2>&1 | FileCheck %s
struct S0 {};
struct S1 { S0 a, b; }; struct S2 { S1 a, b; }; struct S3 { S2 a, b; }; struct S4 { S3 a, b; };
struct S5 { S4 a, b; }; struct S6 { S5 a, b; }; struct S7 { S6 a, b; }; struct S8 { S7 a, b; };
struct S9 { S8 a, b; }; struct S10 { S9 a, b; }; struct S11 { S10 a, b; }; struct S12 { S11 a, b; };
struct S13 { S12 a, b; }; struct S14 { S13 a, b; }; struct S15 { S14 a, b; }; struct S16 { S15 a, b; };
struct S17 { S16 a, b; }; struct S18 { S17 a, b; }; struct S19 { S18 a, b; }; struct S20 { S19 a, b; };
// CHECK: fail_empty_structs.hlsl:[[#@LINE+1]]:8: error: the type has more than 1048576 components [type-too-large, X3059]
struct S21 { S20 a, b; };
cbuffer C { S21 third; float4 plane; };
float4 main(float4 p : POSITION) : SV_Position { return p + plane; }
