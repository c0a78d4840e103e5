// pow of what may be negative, up to 5.1. Oracle: fxc X3571, "pow(f, e) will not work for negative f, use abs(f) or conditionally
// handle negative values if you expect them"; a whole number as the exponent is multiplied, which works. dxc has no word about it.
// RUN: %clipc -T vs_5_0 -fsyntax-only %s 2>&1 | FileCheck %s --implicit-check-not=warning:
// RUN: %clipc -T vs_5_0 -fsyntax-only -Wno-pow-of-negative %s 2>&1 | count 0
// RUN: %clipc -T vs_6_0 -fsyntax-only %s 2>&1 | count 0
Texture2D t;
SamplerState s;
cbuffer Material {
  float3 light;
  float power;
};
float specular(float x) { return pow(x, power); }
float4 main(float4 p : POSITION, float3 n : NORMAL, uint u : U) : SV_Position {
  // CHECK: [[#@LINE+1]]:17: warning: the base of `pow` may be negative; the result is undefined then; use `abs` of it, or `max(0, ...)` [-Wpow-of-negative]
  float a = pow(dot(n, light), power);
  float facing = dot(n, light);
  // CHECK: [[#@LINE+1]]:12: warning: the base of `pow` may be negative
  a += pow(facing, 2.5);
  // CHECK: [[#@LINE+1]]:12: warning: the base of `pow` may be negative
  a += pow(n * 0.5 + 0.5, power).x;
  // CHECK: [[#@LINE+1]]:12: warning: the base of `pow` may be negative
  a += pow(1 - n, power).x;
  float3 lit = max(0, n);
  float changed = -1;
  changed = abs(changed);
  a += pow(lit, power).x + pow(changed, power) + specular(n.x) + pow(u, power);
  a += pow(saturate(n), power).x + pow(n.x * n.x, power) + pow(dot(n, n), power) + pow(2, power);
  a += pow(n, 2).x + pow(n, 5.0).x + pow(1 - saturate(n.y), 5.5) + pow(abs(n.x) + 0.1, power);
  // fxc warns of texels too; the texels of most formats are not negative.
  a += pow(t.SampleLevel(s, p.xy, 0), 2.2).x + pow(t.SampleLevel(s, p.xy, 0).xyz * 2, power).x;
  a += pow(length(n) / 2, power) + pow(n.y < 0 ? 0 : n.y, power) + pow(clamp(n.z, 0, 1), power);
  return p * a;
}
