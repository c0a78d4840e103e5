// RUN: %clipc --dump=ast %s | FileCheck %s
// AUTOUPDATE
#define CLIP [clipplanes(near_plane, \
                         state.planes[2])]
[clipplanes(a)]
float4 one() : SV_Position { return 0; }
CLIP float4 from_macro() : SV_Position { return 0; }
[ClipPlanes(
  a,
  (b),
  s.c[1]
)]
[shader("vertex")]
static [noinline] float4 several() : SV_Position { return 0; }
[[vk::builtin("x")]] [a, b(1)] [[c, ns::d]] float4 lists() { return 0; }
[numthreads(8, 8, 1)] void compute() {}
[RootSignature("CBV(b0), " "SRV(t0)")] void signature() {}
[maxvertexcount] void no_parens();
[misspelt()] void empty_parens();

void statements() {
  [unroll(4)] for (int i = 0; i < 4; i++) x = i;
  [loop] while (x) [branch] if (y) z = 1; else [flatten] if (w) z = 2; else [call] switch (z) { default: break; }
  [fastopt] [allow_uav_condition] do { } while (x);
  [forcecase]
  switch (x) { case 1: break; }
  [branch] { x = 1; }
}
