// The index of a uniform in a fragment shader of GLSL ES 1.00 is made of constants and of the indices of loops (appendix A, 5).
// RUN: %clipc -T ps_5_0 --target=essl100 --blocks=flat --validate %s -o - | FileCheck %s
// RUN: %draw compare %s -T ps_5_0
float4 lights[6];
static const int kFirst = 1;

float4 main(float2 uv : UV) : SV_Target {
  // CHECK: SV_Target0 = lights[kFirst];
  float4 sum = lights[kFirst];
  // CHECK: for (int i = 0; i < 2; i++)
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 3; ++j) {
      // CHECK: lights[i * 3 + j]
      sum += lights[i * 3 + j] * uv.x;
    }
  }
  return sum;
}
