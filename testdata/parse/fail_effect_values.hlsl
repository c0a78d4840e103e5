// RUN: not %clipc -T ps_5_0 %s 2>&1 | FileCheck %s
float4 Made() : SV_Target { return 1; }
// CHECK: [[#@LINE+1]]:15: error: a value of the effects framework in the initialiser of a variable that is not uniform is not supported [unsupported]
static float4 list = { 1, 2, compile ps_4_0 Made(), 4 };
float4 main() : SV_Target {
  // CHECK: [[#@LINE+1]]:10: error: a value of the effects framework in the initialiser of a variable that is not uniform is not supported
  float2 pair = { 1, CompileShader(ps_4_0, Made()) };
  // CHECK: [[#@LINE+1]]:11: error: {{.*}} [unexpected-token, X3000]
  float a { 1 };
  return list;
}
