// The largest struct of empty structs, many times: each pass that walks over its fields stays fast enough for a fuzzer.
// RUN: %clipc -T vs_5_0 %s | FileCheck %s
struct S0 {};
struct S1 { S0 a, b; }; struct S2 { S1 a, b; }; struct S3 { S2 a, b; }; struct S4 { S3 a, b; };
struct S5 { S4 a, b; }; struct S6 { S5 a, b; }; struct S7 { S6 a, b; }; struct S8 { S7 a, b; };
struct S9 { S8 a, b; }; struct S10 { S9 a, b; }; struct S11 { S10 a, b; }; struct S12 { S11 a, b; };
#define FOUR(name) S12 name##0; S12 name##1; S12 name##2; S12 name##3;
cbuffer C { FOUR(a) FOUR(b) FOUR(c) FOUR(d) float4 plane; };
// CHECK:      layout(std140, binding = 0) uniform C {  // b0
// CHECK-NEXT:     vec4 plane;
// CHECK-NEXT: } c;
float4 main(float4 p : POSITION) : SV_Position { return p + plane; }
