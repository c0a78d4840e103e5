// What GLSL has only for vectors is done row by row; matrices of integers and booleans are arrays of rows.
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=glsl120 --validate %s -o %t
// RUN: %clipc -T vs_5_0 --target=essl300 --validate %s -o %t
// AUTOUPDATE
float4x4 a, b;
row_major int3x3 i;

float4 main(float4 p : POSITION) : SV_Position {
  float4 r = abs(a)[0] + max(a, b)[1] + saturate(a)[2] + lerp(a, b, 0.5)[3] + (a % b)[0] + sign(a)[1];
  if (all(a == b) || any(a < b)) r += 1;
  r += (a > b ? a : b)[2];
  bool4x4 both = a > 0 && !(b < 1);
  r.x += both[1][2];
  int3x3 j = i * 2 + i / 3;
  j[1].x = 5;
  j = -j;
  j++;
  r.xyz += j[2] + mul(j, i)[0] + mul(j, int3(1, 2, 3)) + mul(int3(1, 2, 3), j) + transpose(j)[1];
  r.xyz += ((int3x3)a)[0] + ((float3x3)j)[1];
  r += ((float4x4)p.x)[0] + ((float4x4)(p.x * p.y))[1] + ((float4x4)0)[2];
  return r;
}
