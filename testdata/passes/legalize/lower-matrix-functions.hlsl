// Functions of matrices that GLSL has for float matrices only, and dot() of integers, become sums and constructors.
// RUN: %clipc -T vs_5_0 --verify --dump-after=lower-matrix-functions --stop-after=lower-matrix-functions %s | FileCheck %s
// RUN: %draw compare %s -T vs_5_0
// AUTOUPDATE
int2x3 i;
int3 k;
bool2x2 flags;
float4x4 m;

float4 main(float4 p : POSITION) : SV_Position {
  int2 product = mul(i, k);
  int3x2 turned = transpose(i);
  return mul(p, m) + product.xyxy + turned[2].xyxy + dot(k, k) + (any(flags) ? 1 : 0) + ((int2x2)i)[1].xyxy;
}
