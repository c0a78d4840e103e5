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

// CHECK: function one : float4 semantic SV_Position
// CHECK-NEXT:   attribute clipplanes(a)
// CHECK-NEXT:   block
// CHECK-NEXT:     return 0
// CHECK-NEXT: function from_macro : float4 semantic SV_Position
// CHECK-NEXT:   attribute clipplanes(near_plane, state.planes[2])
// CHECK-NEXT:   block
// CHECK-NEXT:     return 0
// CHECK-NEXT: function several : float4 static semantic SV_Position
// CHECK-NEXT:   attribute ClipPlanes(a, b, s.c[1])
// CHECK-NEXT:   attribute shader("vertex")
// CHECK-NEXT:   attribute noinline
// CHECK-NEXT:   block
// CHECK-NEXT:     return 0
// CHECK-NEXT: function lists : float4
// CHECK-NEXT:   attribute vk::builtin("x")
// CHECK-NEXT:   attribute a
// CHECK-NEXT:   attribute b(1)
// CHECK-NEXT:   attribute c
// CHECK-NEXT:   attribute ns::d
// CHECK-NEXT:   block
// CHECK-NEXT:     return 0
// CHECK-NEXT: function compute : void
// CHECK-NEXT:   attribute numthreads(8, 8, 1)
// CHECK-NEXT:   block
// CHECK-NEXT: function signature : void
// CHECK-NEXT:   attribute RootSignature("CBV(b0), SRV(t0)")
// CHECK-NEXT:   block
// CHECK-NEXT: prototype no_parens : void
// CHECK-NEXT:   attribute maxvertexcount
// CHECK-NEXT: prototype empty_parens : void
// CHECK-NEXT:   attribute misspelt()
// CHECK-NEXT: function statements : void
// CHECK-NEXT:   block
// CHECK-NEXT:     attribute unroll(4)
// CHECK-NEXT:     for
// CHECK-NEXT:       init
// CHECK-NEXT:         variable i : int = 0
// CHECK-NEXT:       while (i < 4)
// CHECK-NEXT:       step (i++)
// CHECK-NEXT:       expression (x = i)
// CHECK-NEXT:     attribute loop
// CHECK-NEXT:     while x
// CHECK-NEXT:       attribute branch
// CHECK-NEXT:       if y
// CHECK-NEXT:         expression (z = 1)
// CHECK-NEXT:       else
// CHECK-NEXT:         attribute flatten
// CHECK-NEXT:         if w
// CHECK-NEXT:           expression (z = 2)
// CHECK-NEXT:         else
// CHECK-NEXT:           attribute call
// CHECK-NEXT:           switch z
// CHECK-NEXT:             block
// CHECK-NEXT:               default
// CHECK-NEXT:               break
// CHECK-NEXT:     attribute fastopt
// CHECK-NEXT:     attribute allow_uav_condition
// CHECK-NEXT:     do
// CHECK-NEXT:       block
// CHECK-NEXT:     while x
// CHECK-NEXT:     attribute forcecase
// CHECK-NEXT:     switch x
// CHECK-NEXT:       block
// CHECK-NEXT:         case 1
// CHECK-NEXT:         break
// CHECK-NEXT:     attribute branch
// CHECK-NEXT:     block
// CHECK-NEXT:       expression (x = 1)
