// Arithmetic that IEEE defines to the bit, and functions that only choose or round.
// RUN: %draw compare %s -T vs_5_0 -E main --exact --lower none
// RUN: %draw compare %s -T vs_5_0 -E main --exact --lower none --target glsl120,essl100

float4 k;

struct Output {
  float4 position : SV_Position;
  float4 a : A;
  float4 b : B;
  float4 c : C;
  float4 d : D;
};

float4 Twice(inout float4 value) {
  value *= 2;
  return value + 1;
}

Output main(float4 p : POSITION) {
  Output result;
  result.position = p * k + p / (abs(k) + 1) - k;
  result.a = floor(p) + ceil(k) * frac(p) + trunc(k) + round(p * 2);
  result.b = min(p, k) + max(p, 0.5) + saturate(p) + clamp(k, -1, 1) + step(p, k) + abs(p) + sign(k);
  float4 q = p;
  result.c = Twice(q) + q;
  result.d = float4(fmod(p.x, 0.75), fmod(p.y, -0.75), p.z % 0.5, mad(p.x, p.y, p.z));
  result.d += p < k ? p.wzyx : k;
  return result;
}
