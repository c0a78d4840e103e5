// A scalar is a matrix of one component for the functions of matrices, as in fxc.
// RUN: %clipc -T vs_5_0 -E main --dump=ir %s | FileCheck %s
// RUN: %draw compare %s -T vs_5_0 -E main
float s;
int n;
// CHECK: entry
float4 main(float4 p : POSITION) : SV_Position {
  // CHECK: float1x1 turned = transpose(splat<float1x1>(s))
  float1x1 turned = transpose(s);
  // CHECK: float area = determinant(splat<float1x1>(p.x))
  float area = determinant(p.x);
  // CHECK: transpose(splat<int1x1>(n))
  return float4(turned[0], area, transpose(n), determinant(5)) * p;
}
