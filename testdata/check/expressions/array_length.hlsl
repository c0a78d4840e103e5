// fxc has the number of an array's elements as its member `Length`: DXC's array-length.hlsl, which
// was taken on fxc.
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// RUN: %draw compare %s -T vs_5_0
float4 planes[8];
float4 more[3 + 2];
struct S { float4 rows[2]; };
float4 main(S s : POSITION) : SV_Position {
  float4 local[] = {{1, 2, 3, 4}};
  // CHECK: int total = 8 + 5 + 1 + 2;
  int total = planes.Length + more.Length + local.Length + s.rows.Length;
  float sum[planes.Length];
  sum[7] = total;
  return float4(sum[7], local[0].x, s.rows[1].x, s.rows[0].x);
}
