// Under level 9, indices that are not known even once loops are unrolled and functions are inlined.
// RUN: not %clipc -T vs_4_0_level_9_1 %s -o %t.vert 2>&1 | FileCheck %s
cbuffer Scene {
  float4 plane;
  float4 color;
};

float Sum(float4 v, int from) {
  float sum = 0;
  // CHECK: fail_unknown_indices.hlsl:[[#@LINE+1]]:{{[0-9]+}}: error: the index is not constant; under `vs_4_0_level_9_1` only constants can be indexed at run time [level9-dynamic-index, X4583]
  for (int i = from; i < 4; ++i) sum += v[i];
  // CHECK: :[[#@LINE+1]]:{{[0-9]+}}: error: the index is not constant;
  for (int j = 0; j < color.x; ++j) sum += v[j];
  for (int k = 0; k < 4; ++k) {
    // CHECK: :[[#@LINE+1]]:{{[0-9]+}}: error: the index is not constant;
    sum += v[k];
    k += (int)v.x;
  }
  int last = 0;
  for (int l = 0; l < 2; ++l) last += l;
  // CHECK: :[[#@LINE+1]]:{{[0-9]+}}: error: the index is not constant;
  sum += v[last];
  // CHECK-NOT: error
  for (int m = 0; m < 2; ++m) {
    for (int n = m; n < 2 * m; n += m + 1) sum += v[n];
  }
  return sum;
}

[clipplanes(plane)]
float4 main(float4 v : POSITION) : SV_Position { return Sum(v, 0) + Sum(v, (int)v.x); }
