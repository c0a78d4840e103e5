// The index of a uniform in a fragment shader of GLSL ES 1.00 is made of constants and of the indices of loops (appendix A, 5).
// A buffer that a loop indexes becomes uniform variables; others stay arrays of rows.
// RUN: %clipc -T ps_5_0 --target=essl100 --blocks=flat --validate %s -o - | FileCheck %s
// RUN: %clipc -T ps_5_0 --target=essl100 --validate %s -o %t.frag --reflect=%t.json
// RUN: FileCheck %s < %t.frag
// RUN: FileCheck %s --check-prefix=ROWS < %t.frag
// RUN: FileCheck %s --check-prefix=JSON < %t.json
// RUN: %draw compare %s -T ps_5_0
// CHECK: uniform vec4 lights[6];
// ROWS: uniform vec4 Other[1];
// JSON: "name": "$Globals"
// JSON: "layout": "uniforms"
// JSON: "name": "Other"
// JSON: "layout": "rows"
float4 lights[6];
cbuffer Other { float4 ambient; };
static const int kFirst = 1;

float4 main(float2 uv : UV) : SV_Target {
  // CHECK: vec4 sum = lights[kFirst];
  float4 sum = lights[kFirst];
  // CHECK: for (int i = 0; i < 2; i++)
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 3; ++j) {
      // CHECK: lights[i * 3 + j]
      sum += lights[i * 3 + j] * uv.x;
    }
  }
  return sum + ambient;
}
