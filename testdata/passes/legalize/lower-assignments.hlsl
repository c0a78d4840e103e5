// `a op= b` that GLSL lacks becomes `a = a op b`, or a helper function where `a` has effects.
// RUN: %clipc -T vs_5_0 --verify --dump-after=lower-assignments --stop-after=lower-assignments %s | FileCheck %s
// RUN: %draw compare %s -T vs_5_0
// AUTOUPDATE
float2x2 m;

float4 main(float4 p : POSITION, uint n : COUNT, int2 k : KEY) : SV_Position {
  float2x2 product = m;
  product *= m;
  product += m;
  uint rest = n;
  rest %= 3u;
  int rests[2] = {k.x, k.y};
  int next = 0;
  rests[next++ & 1] %= 5;
  return p + product[0].xyxy + rest + rests[0] + next;
}
