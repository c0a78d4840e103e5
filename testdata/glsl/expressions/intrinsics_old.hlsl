// GLSL 1.20 lacks much of it: functions of HLSL's names stand in.
// RUN: %clipc -T vs_5_0 --target=glsl120 --validate %s -o - | FileCheck %s
// AUTOUPDATE
float4 a;
int4 i;
float2x2 m2;
float3x3 m3;
float4x4 m4;

float4 main(float4 p : POSITION) : SV_Position {
  float4 r = cosh(a) + sinh(a) + tanh(a) + trunc(a) + round(a) + fmod(a, p) + saturate(a);
  float4 whole;
  r += modf(a, whole) + whole;
  r += abs(i) + min(i, 3) + max(i, 4) + clamp(i, 0, 9) + sign(i) + i % 3;
  if (any(isnan(a)) || isinf(a.x) || !isfinite(a.y)) r = a > 0 ? 1 : a;
  r += determinant(m2) + determinant(m3) + determinant(m4);
  return r;
}

// CHECK: #version 120
// CHECK-EMPTY:
// CHECK-NEXT: // $Globals, b0
// CHECK-NEXT: uniform vec4 a;
// CHECK-NEXT: uniform ivec4 i;
// CHECK-NEXT: uniform mat2 m2;
// CHECK-NEXT: uniform mat3 m3;
// CHECK-NEXT: uniform mat4 m4;
// CHECK-EMPTY:
// CHECK-NEXT: attribute vec4 in_POSITION0;  // p : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: vec4 cosh_(vec4 x) {
// CHECK-NEXT:     return 0.5 * (exp(x) + exp(-x));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 sinh_(vec4 x) {
// CHECK-NEXT:     return 0.5 * (exp(x) - exp(-x));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 tanh_(vec4 x) {
// CHECK-NEXT:     vec4 e = exp(-2.0 * abs(x));
// CHECK-NEXT:     return sign(x) * (1.0 - e) / (1.0 + e);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 trunc_(vec4 x) {
// CHECK-NEXT:     return sign(x) * floor(abs(x));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float round_(float x) {
// CHECK-NEXT:     float below = floor(x);
// CHECK-NEXT:     float rest = x - below;
// CHECK-NEXT:     return rest < 0.5 || rest == 0.5 && fract(below * 0.5) == 0.0 ? below : below + 1.0;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 round_(vec4 a) {
// CHECK-NEXT:     return vec4(round_(a.x), round_(a.y), round_(a.z), round_(a.w));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 fmod(vec4 x, vec4 y) {
// CHECK-NEXT:     return x - y * trunc_(x / y);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 saturate(vec4 x) {
// CHECK-NEXT:     return min(max(vec4(0.0), x), 1.0);  // 0 for NaN
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 modf_(vec4 x, out vec4 whole) {
// CHECK-NEXT:     whole = trunc_(x);
// CHECK-NEXT:     return x - whole;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: int abs_(int x) {
// CHECK-NEXT:     return x < 0 ? -x : x;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: ivec4 abs_(ivec4 a) {
// CHECK-NEXT:     return ivec4(abs_(a.x), abs_(a.y), abs_(a.z), abs_(a.w));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: int min_(int x, int y) {
// CHECK-NEXT:     return y < x ? y : x;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: ivec4 min_(ivec4 a, ivec4 b) {
// CHECK-NEXT:     return ivec4(min_(a.x, b.x), min_(a.y, b.y), min_(a.z, b.z), min_(a.w, b.w));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: int max_(int x, int y) {
// CHECK-NEXT:     return x < y ? y : x;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: ivec4 max_(ivec4 a, ivec4 b) {
// CHECK-NEXT:     return ivec4(max_(a.x, b.x), max_(a.y, b.y), max_(a.z, b.z), max_(a.w, b.w));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: int clamp_(int x, int low, int high) {
// CHECK-NEXT:     int y = x < low ? low : x;
// CHECK-NEXT:     return high < y ? high : y;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: ivec4 clamp_(ivec4 a, ivec4 b, ivec4 c) {
// CHECK-NEXT:     return ivec4(clamp_(a.x, b.x, c.x), clamp_(a.y, b.y, c.y), clamp_(a.z, b.z, c.z), clamp_(a.w, b.w, c.w));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: int sign_(int x) {
// CHECK-NEXT:     return x > 0 ? 1 : x < 0 ? -1 : 0;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: ivec4 sign_(ivec4 a) {
// CHECK-NEXT:     return ivec4(sign_(a.x), sign_(a.y), sign_(a.z), sign_(a.w));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: ivec4 imod(ivec4 x, ivec4 y) {
// CHECK-NEXT:     return x - y * (x / y);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: bool isnan_(float x) {
// CHECK-NEXT:     return x != x;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: bvec4 isnan_(vec4 a) {
// CHECK-NEXT:     return bvec4(isnan_(a.x), isnan_(a.y), isnan_(a.z), isnan_(a.w));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: bool isinf_(float x) {
// CHECK-NEXT:     return x != 0.0 && x + x == x;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: bool isfinite(float x) {
// CHECK-NEXT:     return !(isnan_(x) || isinf_(x));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 select(bvec4 a, vec4 b, vec4 c) {
// CHECK-NEXT:     return vec4(a.x ? b.x : c.x, a.y ? b.y : c.y, a.z ? b.z : c.z, a.w ? b.w : c.w);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float determinant2(mat2 m) {
// CHECK-NEXT:     return m[0].x * m[1].y - m[0].y * m[1].x;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float determinant3(mat3 m) {
// CHECK-NEXT:     return dot(m[0], cross(m[1], m[2]));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float determinant4(mat4 m) {
// CHECK-NEXT:     vec2 a = m[0].x * m[1].yz - m[1].x * m[0].yz;
// CHECK-NEXT:     float b = m[0].x * m[1].w - m[1].x * m[0].w;
// CHECK-NEXT:     vec2 c = m[0].yy * m[1].zw - m[1].yy * m[0].zw;
// CHECK-NEXT:     float d = m[0].z * m[1].w - m[1].z * m[0].w;
// CHECK-NEXT:     vec2 e = m[2].x * m[3].yz - m[3].x * m[2].yz;
// CHECK-NEXT:     float f = m[2].x * m[3].w - m[3].x * m[2].w;
// CHECK-NEXT:     vec2 g = m[2].yy * m[3].zw - m[3].yy * m[2].zw;
// CHECK-NEXT:     float h = m[2].z * m[3].w - m[3].z * m[2].w;
// CHECK-NEXT:     return a.x * h - a.y * g.y + b * g.x + c.x * f - c.y * e.y + d * e.x;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     gl_Position = cosh_(a) + sinh_(a) + tanh_(a) + trunc_(a) + round_(a) + fmod(a, in_POSITION0) + saturate(a);
// CHECK-NEXT:     vec4 whole;
// CHECK-NEXT:     gl_Position += modf_(a, whole) + whole;
// CHECK-NEXT:     gl_Position += vec4(abs_(i) + min_(i, ivec4(3)) + max_(i, ivec4(4)) + clamp_(i, ivec4(0), ivec4(9)) + sign_(i) + imod(i, ivec4(3)));
// CHECK-NEXT:     if (any(isnan_(a)) || isinf_(a.x) || !isfinite(a.y)) {
// CHECK-NEXT:         gl_Position = select(greaterThan(a, vec4(0.0)), vec4(1.0), a);
// CHECK-NEXT:     }
// CHECK-NEXT:     gl_Position += determinant2(m2) + determinant3(m3) + determinant4(m4);
// CHECK-NEXT: }
