// A component chosen at run time among several of a matrix can be assigned to, incremented and passed for an inout parameter: the
// components are read, one is changed, and all are written. Oracle: DXC's extmatrix subscripts, HLMatrixLower's "matrix swizzle store".
// RUN: %clipc -T vs_5_0 %s --validate -o - | FileCheck %s
// RUN: %draw compare %s -T vs_5_0 --ints 0..1
int chosen;  // one of --ints
static int calls = 0;
int next() { ++calls; return chosen; }
void twice(inout float x) { x *= 2; }
void whole(inout int x) { x += 2; }
float4 main(float4 p : POSITION) : SV_Position {
  float4x4 m = float4x4(p, p * 2, p * 3, p * 4);
  // CHECK: vec2 temporary = vec2(m[0][0], m[1][1]);
  // CHECK-NEXT: temporary[globals.chosen] = 3.0;
  // CHECK-NEXT: m[0][0] = temporary.x;
  // CHECK-NEXT: m[1][1] = temporary.y;
  m._11_22[chosen] = 3;
  m._m03_m12[chosen] += p.x;
  m._11_22[next()] *= 2;
  float old = m._31_42[chosen]++;
  twice(m._41_13[chosen]);
  whole(m._44_23[chosen]);
  return m[0] + m[1] * 2 + m[2] * 3 + m[3] * 5 + old + calls;
}
