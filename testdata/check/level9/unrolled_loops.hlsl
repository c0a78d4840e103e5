// Under level 9 loops of every kind may count, with several variables, and what they leave in a variable is known after them.
// RUN: %clipc -T vs_4_0_level_9_1 --lower=level9 --table=%t.json --validate %s -o %t.vert
// RUN: %draw compare %s -T vs_4_0_level_9_1
float4 plane;
float4 light[4];
float4 strength;

float Twice(int n) { return n * 2; }
int After(int i) { return i + 1; }

[clipplanes(plane)]
float4 main(float4 position : POSITION, float4 weights : BLENDWEIGHT, out float4 color : COLOR0) : SV_Position {
  float found[4] = {0, 0, 0, 0};
  float sum = 0;
  int a = 0;
  while (a < 3) {
    found[a] = light[a].x;
    a++;
  }
  int b = 0;
  do {
    sum += found[b];
    ++b;
  } while (b < 4);
  for (int i = 0, j = 3; i < 4; ++i, --j) sum += found[j] * weights[i];
  for (int k = 0;; ++k) {
    if (k == 2) break;
    sum += position[k];
  }
  int last = 0;
  for (int l = 0; l < 2; ++l) last += l;
  sum += position[last];
  for (int m = 0; m < 3; m = After(m)) sum += weights[After(m)];
  int step = 0;
  for (int n = 0; n < 4; n++) {
    if (n == 2) continue;
    sum += weights[step];
    step++;
  }
  // What is declared under a condition hangs on nothing outside of it.
  if (strength.x > 0) {
    int q = 1;
    for (; q < 3; ++q) found[q] += 1;
  }
  // A break leaves the loop, and no value of the counter depends on it before.
  for (int r = 0; r < 4; ++r) {
    if (weights.x > r) break;
    sum += position[r];
  }
  switch (last) {
    case 1: last = (int)Twice(1); break;
    default: last = 3; break;
  }
  color = float4(found[0], found[1], found[2], found[3]);
  return position + sum + position[last];
}
