// Operators and functions of matrices that GLSL has for vectors only are done row by row, by helper functions.
// RUN: %clipc -T vs_5_0 --verify --dump-after=lower-matrix-operators --stop-after=lower-matrix-operators %s | FileCheck %s
// RUN: %draw compare %s -T vs_5_0
// AUTOUPDATE
float2x2 m, n;
int2x2 i;

float4 main(float4 p : POSITION) : SV_Position {
  float2x2 larger = max(m, n);
  bool2x2 below = m < n;
  int2x2 counted = i;
  int2x2 old = counted++;
  return p + larger[0].xyxy + (m + n)[1].xyxy + (below[1].x ? 1 : 0) + old[0].xyxy + counted[1].xyxy;
}
