// A matrix of one row or one column is a vector; of one component, a scalar.
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// AUTOUPDATE
cbuffer Values {
  row_major float1x4 row;
  float4x1 column;
  float1x1 one;
};

float4 main(float4 p : POSITION) : SV_Position {
  float4 r = mul(column, row)[2];
  r.x += mul(row, column) + mul(row, p) + mul(p, column);
  r += mul(one, row);
  r.x += row[0][3] + column[3][0] + column[2] + one[0][0];
  r.xy += row._m01_m02;
  r.x += column._m30 + one._m00;
  r += row + transpose(column);
  float3x1 c = column;
  r.xyz += c._m00_m10_m20;
  float1 f = r.x;
  f.x += 1;
  r.xyz += f.xxx;
  return r;
}
