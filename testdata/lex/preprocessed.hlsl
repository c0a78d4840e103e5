// The preprocessed text means what the text does: a macro's end and what follows it stay two tokens, and pragmas for the compiler are kept in their places.
// RUN: %clipc %s -P %t.hlsl
// RUN: FileCheck %s < %t.hlsl
// RUN: %clipc %s -o %t.vert && %clipc %t.hlsl -o %t.again.vert -Werror && diff %t.vert %t.again.vert
// RUN: %clipc %s -o %t.vert -Werror
// CHECK: #pragma warning(disable : 3206)
// CHECK-NEXT: #pragma def(vs_5_0, c0, 1.0, 2.0, 3.0, 4.0)
// CHECK: #pragma pack_matrix(row_major)
#pragma warning(disable : 3206)
#pragma def(vs_5_0, c0, 1.0, \
            2.0, 3.0, 4.0)  // for Direct3D
#pragma pack_matrix(row_major)
#pragma once
#define NEG -
#define PLUS +
#define AND &
#define LESS <
#define OVER /
#define NAME x
#define TWO 2
// CHECK: float4 main(float4 p : P, int i : I)
float4 main(float4 p : P, int i : I) : SV_Position {
  // CHECK: float4 x = - -p;
  float4 x = NEG-p;
  // CHECK: x = x + +p;
  x = NAME PLUS+p;
  // CHECK: i = (i & 1) + 2;
  i = (i AND 1) + TWO;
  float2 cut = x;
  return x * i + cut.x;
}
