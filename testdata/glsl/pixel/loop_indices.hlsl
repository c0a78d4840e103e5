// The index of a uniform in a fragment shader of GLSL ES 1.00 is made of constants and of the indices of loops (appendix A, 5).
// A macro reads the element of an array of rows: a function's parameter is not such an index, and browsers refuse it.
// RUN: %clipc -T ps_5_0 --target=essl100 --blocks=flat --validate %s -o - | FileCheck %s
// RUN: %clipc -T ps_5_0 --target=essl100 --validate %s -o - | FileCheck %s --check-prefix=ROWS
// RUN: %clipc -E vertex --pixel-entry=main --pixel-output=%t.frag --target=essl100 --validate %s -o %t.vert
// RUN: FileCheck %s --check-prefix=ROWS < %t.frag
// RUN: FileCheck %s --check-prefix=VERTEX < %t.vert
// RUN: %draw compare %s -T ps_5_0
// CHECK: uniform vec4 lights[6];
// ROWS: uniform vec4 Globals[20];
// ROWS: // offset 0
// ROWS-NEXT: #define lights(i) (Globals[(i)])
// ROWS: // offset 96
// ROWS-NEXT: #define turned(i) (mat3(Globals[3 * (i) + 6].xyz, Globals[3 * (i) + 7].xyz, Globals[3 * (i) + 8].xyz))
// VERTEX: vec4 lights(int i) {  // offset 0
float4 lights[6];
row_major float3x3 turned[2];
float weights[8];
static const int kFirst = 1;

float4 vertex(float4 p : POSITION) : SV_Position { return p * lights[int(p.x)] * weights[7]; }

float4 main() : SV_Target {
  // CHECK: SV_Target0 = lights[kFirst];
  // ROWS: SV_Target0 = lights(kFirst);
  float4 sum = lights[kFirst];
  // CHECK: for (int i = 0; i < 2; i++)
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 3; ++j) {
      // CHECK: lights[i * 3 + j]
      // ROWS: lights(i * 3 + j)
      sum += lights[i * 3 + j];
    }
    // ROWS: turned(i)
    sum.xyz = mul(turned[i], sum.xyz) * weights[2];
  }
  return sum;
}
