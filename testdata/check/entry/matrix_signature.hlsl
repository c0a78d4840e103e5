// A matrix in a signature takes a register for each column, and one for each row where it is
// row_major.
// RUN: %clipc -T vs_5_0 %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 %s -o - -Zpr | FileCheck %s --check-prefix=ROWS
// RUN: %draw compare %s -T vs_5_0
// RUN: %draw compare %s -T vs_5_0 --target=essl300
struct In {
  float4 position : POSITION;
  // CHECK: in vec4 in_COLUMNS0;
  // CHECK-NEXT: in vec4 in_COLUMNS1;
  // CHECK-NEXT: in vec4 in_COLUMNS2;
  // CHECK-NEXT: in vec3 in_ROWS0;
  // CHECK-NEXT: in vec3 in_ROWS1;
  // CHECK-NEXT: in vec3 in_ROWS2;
  // CHECK-NEXT: in vec3 in_ROWS3;
  // ROWS: in vec3 in_COLUMNS3;
  // ROWS-NEXT: in vec3 in_ROWS0;
  float4x3 columns : COLUMNS;
  row_major float4x3 rows : ROWS;
};
// CHECK: in vec2 in_ARRAY3;
struct Out {
  float4 position : SV_Position;
  // CHECK: out vec2 vs_MIXED2;
  // CHECK: out vec3 vs_EVEN1;
  float2x3 mixed : MIXED;
  row_major float2x3 even : EVEN;
};
Out main(In i, float2x2 array[2] : ARRAY) {
  Out o;
  o.position = float4(mul(i.position, i.columns) + mul(i.position, i.rows), 1);
  o.position.xy += mul(array[0][1], array[1]);
  o.mixed = float2x3(i.columns[0], i.rows[3]);
  o.even = o.mixed * 2;
  return o;
}
