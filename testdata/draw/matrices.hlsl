// Every way to write and to store a matrix; additions and products only, so equal to the bit but for the order in a sum.
// RUN: %draw compare %s -T vs_5_0 -E main --ints 0..3
// RUN: %draw compare %s -T vs_5_0 -E main --ints 0..3 --lower none --target glsl120,essl100
// RUN: %draw compare %s -T vs_5_0 -E main --ints 0..3 --lower none --target essl100 --row-major
// RUN: %draw compare %s -T vs_5_0 -E main --ints 0..3 --row-major --target glsl450,glsl330

float4x4 square;
row_major float4x4 square_by_rows;
column_major float3x4 wide;
row_major float4x3 tall;
float2x2 small[3];
row_major float2x3 odd;
float3x1 column;
row_major float1x3 row;
struct Bone {
  row_major float3x4 transform;
  float4x2 coordinates;
};
Bone bones[2];
int which;  // one of --ints

struct Output {
  float4 position : SV_Position;
  float4 a : A;
  float4 b : B;
  float4 c : C;
  float4 d : D;
  float4 e : E;
};

Output main(float4 position : POSITION, float3 normal : NORMAL) {
  Output result;
  result.position = mul(position, square) + mul(square_by_rows, position);
  result.a = float4(mul(wide, position), mul(normal, wide).w) + float4(mul(position, tall), mul(tall, normal).x);
  result.b = float4(mul(small[2], normal.xy), mul(normal.xy, odd).yz) + square[1] + square._m30_m21_m12_m03;
  float4x4 both = mul(square, square_by_rows);
  both[2] = position;
  both._m00_m11 = normal.xy;
  result.c = mul(both, position) + square_by_rows[which] * 2;
  result.d = float4(mul(bones[1].transform, position), mul(position, bones[0].coordinates).y);
  float3x3 part = (float3x3)square;
  result.e = float4(mul(part, normal) + mul(transpose(part), normal), mul(normal, column) + mul(row, normal));
  return result;
}
