// What only some paths write: fxc X4000, "use of potentially uninitialized variable". What a later condition may exclude is not named.
// RUN: %clipc -T vs_5_0 -fsyntax-only %s 2>&1 | FileCheck %s --implicit-check-not=warning:
// RUN: %clipc -T vs_6_0 -fsyntax-only %s 2>&1 | FileCheck %s --implicit-check-not=warning:
// RUN: %clipc -T vs_5_0 -fsyntax-only -Wno-variable-not-always-written -Wno-out-parameter-not-always-written %s 2>&1 | count 0
int count;
float limit;
float3 lights[4];
float one_way(float3 p) {
  float x;
  if (p.x > 5) x = 1;
  // CHECK: [[#@LINE+1]]:10: warning: `x` is read where not every path has written it; where none has, its value is undefined; give it a value where it is declared [-Wvariable-not-always-written]
  return x * p.y;
  // CHECK: [[#@LINE-4]]:9: note: `x` is declared here
}
float both_ways(float3 p) {
  float x, y;
  if (p.x > 5) x = 1; else if (p.y > 2) x = 2; else x = 3;
  if (p.x > 5) { y = 1; } else { return 0; }
  return x * y;
}
float chain(float3 p) {
  float x;
  if (p.x > 5) x = 1; else if (p.y > 2) x = 2;
  // CHECK: [[#@LINE+1]]:10: warning: `x` is read where
  return x;
}
float loops(float3 p) {
  float3 x, y;
  for (int i = 0; i < count; ++i) x = lights[i];
  for (int j = 0; j < 4; ++j) y = lights[j];
  // CHECK: [[#@LINE+1]]:14: warning: `x` is read where
  return dot(x, y);
}
float whiles(float3 p) {
  float x, y, z;
  while (p.x > limit) { x = p.x; p.x -= 1; }
  int left = 3;
  while (left > 0) { y = p.y; --left; }
  do { z = p.z; --left; } while (left > count);
  // CHECK: [[#@LINE+1]]:10: warning: `x` is read where
  return x + y + z;
}
float in_loop(float3 p) {
  float sum = 0;
  for (int i = 0; i < 4; ++i) {
    float x;
    if (lights[0].x > 0) x = 2;
    // CHECK: [[#@LINE+1]]:12: warning: `x` is read where
    sum += x;
  }
  return sum;
}
float switches(float3 p, int kind) {
  float x, y;
  switch (kind) { case 0: x = 1; break; case 1: x = 2; break; }
  switch (kind) { case 0: y = 1; break; default: y = 2; break; }
  // CHECK: [[#@LINE+1]]:10: warning: `x` is read where
  return x + y;
}
float parts(float3 p) {
  float4 v;
  v.x = 1;
  if (p.x > 0) v.yz = p.xy;
  // CHECK: [[#@LINE+1]]:10: warning: `v` is read where
  return v.y + v.x;
}
// Conditions that may go together.
float together(float3 p, bool a) {
  float x, y, z, w;
  bool found = false;
  if (a) x = 1;
  if (p.x > 0) p.y += a ? x : 0;
  if (a && x > 1) p.y += 1;
  if (a) { y = p.x; found = true; }
  if (!found) return 0;
  for (int i = 0; i < 4; ++i) {
    if (i == 0) z = lights[i].x;
    p.y += z;
  }
  for (int k = 0; k < 4; ++k) { if (lights[k].y > 2) { w = k; break; } }
  return y + z + w + p.y;
}
// fxc knows the constants of calls.
float by_call(float3 p, int kind) {
  float x;
  if (kind == 0) x = p.x; else if (kind == 1) x = p.y;
  for (int i = 0; i < kind; ++i) p.x += x;
  return x;
}
// CHECK: [[#@LINE+1]]:30: warning: the out parameter `y` is not written on every path; where it is not, the caller gets what is undefined [-Wout-parameter-not-always-written]
void bend(float x, out float y) { if (x > 0) y = x; }
// CHECK: [[#@LINE+1]]:31: warning: the out parameter `hit` is not written
void early(float x, out float hit) { if (x < 0) return; hit = x; }
// The result says which.
bool trace(float x, out float hit) { if (x > 0) { hit = x; return true; } return false; }
void all_of(float x, out float2 y) { if (x > 0) { y = x; return; } y.x = 1; y.y = 2; }
float4 main(float4 p : POSITION, int k : K) : SV_Position {
  float a, b, c;
  float2 d;
  bend(p.x, a); early(p.x, b); all_of(p.y, d);
  float r = one_way(p.xyz) + both_ways(p.xyz) + chain(p.xyz) + loops(p.xyz) + whiles(p.xyz) + in_loop(p.xyz);
  r += switches(p.xyz, k) + parts(p.xyz) + together(p.xyz, k > 1) + by_call(p.xyz, 0) + by_call(p.xyz, 1);
  if (trace(p.x, c)) r += c;
  return r + a + b + d.x;
}
