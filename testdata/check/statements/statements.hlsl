// RUN: %clipc -T vs_5_0 -E main --dump=ir %s | FileCheck %s
float next(inout float x) { x += 1; return x; }
float4 main(float4 v : POSITION, uint id : SV_VertexID) : SV_Position {
  float s = 0;
  // fxc leaves the variable of a loop visible after it: it moves to the top.
  // CHECK: int last
  // CHECK: for (last = 0; last < 3; last++) {
  for (int last = 0; last < 3; last++) {
    // CHECK: if (last == 1) {
    if (last == 1) continue;
    // CHECK: s += convert<float>(last)
    s += last;
  }
  // CHECK: s *= convert<float>(last)
  s *= last;
  // CHECK: for (int i = 0, int j = 1; (i < 3) && (j < 3); (i++), (j += 2)) {
  [unroll] for (int i = 0, j = 1; i < 3 && j < 3; i++, j += 2) s += i * j;
  // CHECK: for (int i.1 = 4; convert<bool>(i.1); i.1--) {
  [loop] for (int i = 4; i; i--) s -= i;
  // CHECK: while (true) {
  while (true) {
    if (s > 1) break;
    s += 1;
  }
  // CHECK: do {
  do s -= 1; while (s > 0);
  // CHECK: switch (id & 3u) {
  [branch] switch (id & 3) {
    // CHECK-NEXT: case 0u:
    // CHECK-NEXT: case 1u:
    case 0:
    case 1:
      s = 1;
      break;
    // CHECK: case 2u:
    case 2: {
      s += 2;
      break;
    }
    // CHECK: default:
    default:
      s = 4;
      break;
  }
  // CHECK: if (s > 1.0) {
  // CHECK: if (s > 2.0) {
  // CHECK: } else {
  if (s > 1) s = 1; else if (s > 2) s = 2; else s = 3;
  static float remembered = 1;
  static const float2 kPair = {1, 2};
  // CHECK: float t = next(s)
  float t = next(s), u = t;
  ;
  { float t = 2; u += t; }
  const int size = 2;
  float list[size] = {1, 2};
  // CHECK: remembered += (kPair.x + u) + list[1]
  remembered += kPair.x + u + list[1];
  return v * s * remembered;
}
