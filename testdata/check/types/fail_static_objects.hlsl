// RUN: not %clipc -T ps_5_0 %s 2>&1 | FileCheck %s
Texture2D a, b;
static Texture2D none, twice;
float4 main(int2 p : P) : SV_Target {
  twice = a;
  // CHECK: [[#@LINE+1]]:3: error: `twice` of type `Texture2D<float4>` is not one particular global; {{.*}} [object-not-global, X3031]
  twice = b;
  // CHECK: [[#@LINE+1]]:10: error: `none` of type `Texture2D<float4>` is not one particular global; {{.*}} [object-not-global, X3031]
  return none[p] + twice[p];
}
