// RUN: not %clipc -T vs_5_0 %s -o - 2>&1 | FileCheck %s
float4 main(float4 v : POSITION, int i : INDEX) : SV_Position {
  float4x4 m = 0;
  // CHECK: fail_matrix_swizzle_targets.hlsl:[[#@LINE+1]]:3: error: components are repeated; each can be assigned only once [swizzle-repeats, X3025]
  m._m00_m00 = v.xy;
  // CHECK: :[[#@LINE+1]]:3: error: components are repeated;
  m._11_22.xx = v.xy;
  // CHECK: :[[#@LINE+1]]:16: error: argument 2 of `sincos` is written to; it must be a variable or a part of one
  sincos(v.xy, m._m00_m00, v.xy);
  // CHECK: :[[#@LINE+1]]:15: error: argument 2 of `sincos` is written to; it must be a variable or a part of one
  sincos(v.x, m._11_22[i], v.x);
  // CHECK: :[[#@LINE+1]]:15: error: argument 2 of `sincos` is written to; it must be a variable or a part of one
  sincos(v.x, v.xx[i], v.x);
  return m[0];
}
