// An out parameter is written completely. Oracles: fxc X3508, an error; dxc has a warning, -Wparameter-usage.
// RUN: not %clipc -T vs_5_0 -fsyntax-only %s 2>&1 | FileCheck %s --check-prefixes=CHECK,FXC
// RUN: %clipc -T vs_6_0 -fsyntax-only %s 2>&1 | FileCheck %s --check-prefixes=CHECK,DXC
// RUN: %clipc -T vs_6_0 -fsyntax-only -Wno-out-parameter-undefined %s 2>&1 | count 0
struct Part {
  float a;
  float2 b;
};
// FXC: [[#@LINE+2]]:31: error: the out parameter `r` is never written; the caller gets what is undefined [out-parameter-not-written, X3508]
// DXC: [[#@LINE+1]]:31: warning: the out parameter `r` is never written; the caller gets what is undefined [-Wout-parameter-undefined]
void never(float p, out float r) {}
// CHECK: [[#@LINE+1]]:29: {{.*}}: the out parameter `r` is not written completely
void part(float p, out Part r) { r.a = p; r.b.y = p; }
// Each of these is written.
void branches(float p, out Part r) {
  if (p > 0) {
    r = (Part)p;
    return;
  }
  r.a = p;
  r.b.xy = p;
}
void inner(float p, out Part r) { branches(p, r); }
void indexed(int i, out float r[20]) { r[i] = 1; }
void frexps(float p, out float r) { frexp(p, r); }
float4 main(float4 p : POSITION) : SV_Position {
  float a, c, d[20];
  Part b, e;
  never(p.x, a);
  part(p.x, b);
  inner(p.y, e);
  indexed(1, d);
  frexps(p.z, c);
  return p + a + b.a + c + d[2] + e.a;
}
