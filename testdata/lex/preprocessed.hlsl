// The preprocessed text means what the text does: a macro's end and what follows it stay two tokens.
// RUN: %clipc %s -P %t.hlsl
// RUN: FileCheck %s < %t.hlsl
// RUN: %clipc %s -o %t.vert && %clipc %t.hlsl -o %t.again.vert && diff %t.vert %t.again.vert
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
  return x * i;
}
