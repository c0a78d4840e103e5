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
  // CHECK-NOT: error
  for (int m = 0; m < 2; ++m) {
    for (int n = m; n < 2 * m; n += m + 1) sum += v[n];
  }
  return sum;
}

static int counter = 0;
void Count() { counter++; }
void Set(out int n) { n = (int)color.x; }
int Side() {
  if (color.x > 0) return 1;
  return 2;
}

// What an assignment hangs on, and where values come from.
float Hang(float4 v) {
  float sum = 0;
  int a = 0;
  // CHECK: :[[#@LINE+1]]:{{[0-9]+}}: error: the index is not constant;
  while (a < v.x) sum += v[a++];
  int b = 0;
  // CHECK: :[[#@LINE+1]]:{{[0-9]+}}: error: the index is not constant;
  do sum += v[b]; while (++b < v.y);
  int c = 0;
  if (v.x > 0) c = 1;
  // CHECK: :[[#@LINE+1]]:{{[0-9]+}}: error: the index is not constant;
  sum += v[c];
  int d;
  Set(d);
  // CHECK: :[[#@LINE+1]]:{{[0-9]+}}: error: the index is not constant;
  sum += v[d];
  for (int e = 0, f = 0; e < 3; ++e) {
    // CHECK-NOT: error
    sum += v[e];
    if (v.x > e) continue;
    f++;
    // CHECK: :[[#@LINE+1]]:{{[0-9]+}}: error: the index is not constant;
    sum += v[f];
  }
  int g = 0;
  for (;;) {
    if (v.x < g) break;
    // CHECK: :[[#@LINE+1]]:{{[0-9]+}}: error: the index is not constant;
    sum += v[g];
    ++g;
  }
  // CHECK: :[[#@LINE+1]]:{{[0-9]+}}: error: the index is not constant;
  sum += v[Side()];
  Count();
  // CHECK: :[[#@LINE+1]]:{{[0-9]+}}: error: the index is not constant;
  sum += v[counter];
  int t[2] = {0, 1};
  t[a] = 1;
  // CHECK: :[[#@LINE-1]]:{{[0-9]+}}: error: the index is not constant;
  // CHECK: :[[#@LINE+1]]:{{[0-9]+}}: error: the index is not constant;
  sum += v[t[0]];
  int h = 0;
  switch ((int)v.x) {
    case 0: h = 1; break;
  }
  // CHECK: :[[#@LINE+1]]:{{[0-9]+}}: error: the index is not constant;
  sum += v[h];
  int i = 0;
  switch (1) {
    case 1:
      if (v.x > 0) break;
      i = 1;
      break;
  }
  // CHECK: :[[#@LINE+1]]:{{[0-9]+}}: error: the index is not constant;
  sum += v[i];
  // CHECK-NOT: error
  return sum;
}

[clipplanes(plane)]
float4 main(float4 v : POSITION) : SV_Position { return Sum(v, 0) + Sum(v, (int)v.x) + Hang(v); }
