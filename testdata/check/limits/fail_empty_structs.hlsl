// Structs of empty structs have no size, and each still doubles the time of a walk over the one that holds it.
// RUN: not %clipc -T vs_5_0 %s 2>&1 | FileCheck %s
struct S0 {};
struct S1 { S0 a, b; }; struct S2 { S1 a, b; }; struct S3 { S2 a, b; }; struct S4 { S3 a, b; };
struct S5 { S4 a, b; }; struct S6 { S5 a, b; }; struct S7 { S6 a, b; }; struct S8 { S7 a, b; };
struct S9 { S8 a, b; }; struct S10 { S9 a, b; }; struct S11 { S10 a, b; }; struct S12 { S11 a, b; };
struct S13 { S12 a, b; };
// CHECK: fail_empty_structs.hlsl:[[#@LINE+1]]:8: error: the type has more than 16384 fields [type-too-large, X3059]
struct S14 { S13 a, b; };
cbuffer C { S14 third; float4 plane; };
float4 main(float4 p : POSITION) : SV_Position { return p + plane; }
