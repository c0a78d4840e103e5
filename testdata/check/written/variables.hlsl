// What is read, or left to the next stage, and never written before. Oracles: fxc X4000, a warning, for variables and for outputs (it
// compiles ContactHardeningShadows11.hlsl of the DirectX SDK, whose output f4SMC nothing writes).
// RUN: %clipc -T vs_5_0 -fsyntax-only %s 2>&1 | FileCheck %s --implicit-check-not=warning:
// RUN: %clipc -T vs_5_0 -fsyntax-only -Wno-variable-not-written -Wno-output-not-written %s 2>&1 | count 0
struct Part {
  float3 a;
  float b[2];
};
struct Out {
  float4 position : SV_Position;
  // CHECK: [[#@LINE+1]]:18: warning: the output `color` is never written; the next stage reads what is undefined [-Woutput-not-written]
  float4 color : COLOR;
  // CHECK: [[#@LINE+1]]:15: warning: the output `uv` is not written completely; the next stage reads what is undefined [-Woutput-not-written]
  float4 uv : UV;
};
// Nothing writes y before z is, and a swizzle that has been written in part is written.
float2 swizzles(float2 p) {
  float4 v;
  v.xz = p;
  // CHECK: [[#@LINE+1]]:13: warning: `v` is read before anything is written to it; its value is undefined [-Wvariable-not-written]
  float w = v.y;
  // CHECK: [[#@LINE-4]]:10: note: `v` is declared here
  return v.xy + w;
}
float loops(float2 p, int n) {
  float last, sum, never;
  for (int i = 0; i < n; ++i) {
    if (i > 0) p.x += last + sum;
    last = p.x;
    sum += p.y;
    // CHECK: [[#@LINE+1]]:25: warning: `never` is read before anything is written to it; its value is undefined [-Wvariable-not-written]
    if (p.y > 3) p.x += never;
  }
  return p.x;
}
float branches(float2 p) {
  float one, other, none;
  if (p.x > 0) one = 1;
  if (p.x > 1) return one;
  if (p.y > 0)
    other = 2;
  else
    // CHECK: [[#@LINE+1]]:11: warning: `other` is read before anything is written to it; its value is undefined [-Wvariable-not-written]
    p.x = other;
  // CHECK: [[#@LINE+1]]:24: warning: `none` is read before anything is written to it; its value is undefined [-Wvariable-not-written]
  return p.x + other + none;
}
void scale(inout Part part, inout float f) { part.a *= f; }
Out main(float4 p : POSITION, int n : N) {
  Out o;
  Part part, copy;
  float f;
  part.a = p.xyz;
  scale(part, f);
  copy = part;
  float table[20];
  table[n] = 1;
  o.position = p + copy.b[1] + table[3] + swizzles(p.xy).x + loops(p.xy, n) + branches(p.xy);
  o.uv.xy = p.xy;
  Part unwritten;
  // CHECK: [[#@LINE+1]]:13: warning: `unwritten` is read before anything is written to it; its value is undefined [-Wvariable-not-written]
  o.uv.x += unwritten.b[1];
  return o;
}
