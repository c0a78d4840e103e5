// Functions whose results rounding may change a little.
// RUN: %draw compare %s -T vs_5_0 -E main --lower none
// RUN: %draw compare %s -T vs_5_0 -E main --lower none --target glsl120,essl100

float4 k;

struct Output {
  float4 position : SV_Position;
  float4 a : A;
  float4 b : B;
  float4 c : C;
  float4 d : D;
  float4 e : E;
  float4 f : F;
};

Output main(float4 p : POSITION, float3 n : NORMAL) {
  Output result;
  result.position = float4(dot(p, k), length(n), distance(p.xy, k.xy), dot(n, n));
  result.a = float4(normalize(n + float3(3, 0, 0)), rsqrt(abs(p.x) + 1));
  result.b = float4(sin(p.x), cos(p.y), exp2(p.z), exp(p.w));
  result.c = float4(log2(abs(p.x) + 1), log(abs(p.y) + 1), pow(abs(p.z) + 0.5, k.x), sqrt(abs(p.w)));
  result.d = lit(dot(n, k.xyz), p.x, 3) + dst(p, k);
  float s, c;
  sincos(p.x, s, c);
  result.e = float4(s, c, tan(p.y * 0.5), atan2(p.z, abs(p.w) + 1)) + float4(reflect(n, normalize(k.xyz + 3)), 0);
  result.f = float4(cross(n, k.xyz), determinant(float3x3(n, k.xyz, p.xyz))) + smoothstep(-2, 2, p) + lerp(p, k, n.x);
  return result;
}
