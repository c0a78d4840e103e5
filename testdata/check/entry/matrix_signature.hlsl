// A matrix in a signature takes a register for each column, and one for each row where it is
// row_major. As an output it is one variable, of its rows, where DXC's and glslang's pixel shaders
// have one: where outputs have locations, or names that are not HLSLcc's.
// RUN: %clipc -T vs_5_0 %s -o - --names=hlslcc | FileCheck %s
// RUN: %clipc -T vs_5_0 %s -o - --names=hlslcc -Zpr | FileCheck %s --check-prefix=ROWS
// RUN: %clipc -T vs_5_0 %s -o - --target=glsl330 | FileCheck %s
// RUN: %clipc -T vs_5_0 %s -o - --validate --reflect=%t.json | FileCheck %s --check-prefix=WHOLE
// RUN: FileCheck %s --input-file=%t.json --check-prefix=JSON
// RUN: %clipc -T vs_5_0 %s -o - --validate --target=vulkan | FileCheck %s --check-prefix=WHOLE
// RUN: %clipc -T vs_5_0 %s -o - --validate --target=glsl330 --names=dxc | FileCheck %s --check-prefix=NAMED
// RUN: %clipc -T vs_5_0 %s -o - --validate --target=webgl1 --names=dxc | FileCheck %s --check-prefix=SQUARE
// SQUARE-NOT: mat2x3
// WHOLE:      layout(location = 0) out mat2x3 vs_MIXED0;
// WHOLE-NEXT: layout(location = 2) out mat2x3 vs_EVEN0;
// WHOLE:      vs_MIXED0[1] =
// NAMED:      out mat2x3 in_var_MIXED;
// NAMED-NEXT: out mat2x3 in_var_EVEN;
// JSON-NOT:   pixelInput
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
