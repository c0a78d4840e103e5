// The end of a function is judged by what control can reach: a `break` after a `return` leaves nothing, and known conditions are
// known. Xbox-ATG-Samples builds GBufferPS.hlsl, with `default: if (t) return a; else return b; break;`, with fxc at 5.1.
// RUN: %clipc -T vs_5_0 -fsyntax-only -Wno-unreachable-code %s 2>&1 | FileCheck %s --implicit-check-not=error: --implicit-check-not=warning:
// RUN: %clipc -T vs_5_0 --validate -Wno-unreachable-code %s -o - 2>&1 | FileCheck %s --check-prefix=GLSL
// RUN: %clipc -T vs_3_0 -DOLD -fsyntax-only -Wno-unreachable-code %s
// RUN: %draw compare %s -T vs_5_0
float in_switch(int k, float a, float b) {
  switch (k) {
    case 0: return a; break;
    default:
      if (a > b) return a;
      else return b;
      break;
  }
}
float in_loop(float a) { for (;;) { if (a > 1) return a; else return 2; break; } }
float in_while(float a) { while (true) { return a; break; } }
float in_do(float a) { do { if (a > 1) continue; return a; } while (true); }
float nested(float a) { while (true) { for (int i = 0; i < 2; ++i) { if (a > i) break; } return a; } }
float never_breaks(float a) { for (;;) { if (false) break; return a; } }
float known_case(float a) { switch (1) { case 0: break; case 1: return a; } }
// Source SDK 2013 ships functions of this form, which are called with constants.
float3 fog(float3 c, const int kind) { if (kind == 0) return c * 0.5; else if (kind == 1) return c; }
float3 by_way(float3 c, int kind) { const int same = kind; return fog(c, same); }
float3 by_flag(float3 c, bool a, bool b) { if (a && b) return c; if (!a || !b) return -c; }
float noise(float3 c, uniform int kind) { switch (kind) { case 2: return c.x; case 3: return c.y; } }
// The last two conditions are not known: 0 where neither holds.
// CHECK: [[#@LINE+1]]:7: warning: `some` may reach its end without a `return`; the result is 0 there; end it with a `return` [-Wend-without-return]
float some(float x, const int kind) { if (kind == 0) return 1; if (x > 2) return x; }
// GLSL: float some(float x, int kind) {
// GLSL: return 0.0;
// Dead calls do not count.
float dead(float x, int kind) { if (kind == 4) return x; }
float4 main(float4 p : POSITION, int k : K) :
#ifdef OLD
POSITION
#else
SV_Position
#endif
{
  float4 r = in_switch(k, p.x, p.y) + in_loop(p.x) + in_while(p.x) + in_do(min(p.x, 1)) + nested(p.x) + never_breaks(p.x);
  r += known_case(p.z) + noise(p.xyz, 3) + some(p.x, 1) + dead(p.y, 4);
  r.xyz += fog(p.xyz, 1) + fog(p.xyz, 0) + by_way(p.xyz, 0) + by_flag(p.xyz, true, true) + by_flag(p.xyz, true, false);
  if (false) r.x += dead(p.z, 5);
  return r;
}
