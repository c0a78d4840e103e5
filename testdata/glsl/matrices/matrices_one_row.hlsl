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
  float3x1 c = (float3x1)column;
  r.xyz += c._m00_m10_m20;
  float1 f = r.x;
  f.x += 1;
  r.xyz += f.xxx;
  return r;
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 0) uniform Values {  // b0
// CHECK-NEXT:     vec4 row;
// CHECK-NEXT:     vec4 column;
// CHECK-NEXT:     float one;
// CHECK-NEXT: } values;
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     gl_Position = outerProduct(values.row, values.column)[2];
// CHECK-NEXT:     gl_Position.x += dot(values.row, values.column) + dot(values.row, in_POSITION0) + dot(in_POSITION0, values.column);
// CHECK-NEXT:     gl_Position += values.one * values.row;
// CHECK-NEXT:     gl_Position.x += values.row.w + values.column.w + values.column.z + values.one;
// CHECK-NEXT:     gl_Position.xy += values.row.yz;
// CHECK-NEXT:     gl_Position.x += values.column.w + values.one;
// CHECK-NEXT:     gl_Position += values.row + values.column;
// CHECK-NEXT:     vec3 c = values.column.xyz;
// CHECK-NEXT:     gl_Position.xyz += c.xyz;
// CHECK-NEXT:     float f = gl_Position.x;
// CHECK-NEXT:     f += 1.0;
// CHECK-NEXT:     gl_Position.xyz += vec3(f);
// CHECK-NEXT: }
