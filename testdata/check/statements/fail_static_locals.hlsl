// Up to 5.1 the initial value of a static variable does not depend on the call: glslang's issue 1432, by an author of DXC, says that
// fxc does not accept `static const float v = val;`. Constants and uniforms are the same in all calls.
// RUN: not %clipc -T vs_5_0 -fsyntax-only %s 2>&1 | FileCheck %s --implicit-check-not=error:
// RUN: %clipc -T vs_6_0 -fsyntax-only %s
float size;
static const float kHalf = 0.5;
static float g = 9;
float f(float x, int n) {
  // CHECK: [[#@LINE+1]]:20: error: the initial value of the static variable `a` is computed from `x`; up to shader model 5.1 it does not depend on the call; {{.*}} [static-not-constant, X3011]
  static float a = x * 2;
  float local = 3;
  // CHECK: [[#@LINE+1]]:27: error: {{.*}} `b` is computed from `local`
  static const float2 b = {1, local};
  const float k = 2;
  const float2 v = {1, 2};
  static float c = k * kHalf / size, d = g, e = v.x;
  for (int i = 0; i < 4; ++i) {
    // CHECK: [[#@LINE+1]]:25: error: {{.*}} `h` is computed from `i`
    static float h[2] = {i, 1};
    a += h[0];
  }
  return a + b.x + c + d + e;
}
struct S {
  float m;
  // CHECK: [[#@LINE+1]]:38: error: {{.*}} `s` is computed from `this`
  float f() { static const float s = m; return s; }
};
float4 main(float4 p : POSITION) : SV_Position {
  S s = {p.x};
  return p * f(p.x, 1) * s.f();
}
