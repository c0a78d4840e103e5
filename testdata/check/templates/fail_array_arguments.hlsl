// RUN: not %clipc -T vs_6_0 -HV 2021 %s -o - 2>&1 | FileCheck %s
template <typename T> struct Holder { T held; };
float4 main(float4 p : POSITION) : SV_Position {
  // CHECK: [[#@LINE+1]]:16: error: {{.*}} [bad-array-size
  Holder<float[0]> none;
  return p;
}
