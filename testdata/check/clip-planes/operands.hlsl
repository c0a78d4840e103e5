// Every form of a clip plane that is allowed, and what it becomes. fxc's rules; DXC refuses most of these after accepting them.
// RUN: %clipc -T vs_5_1 -E main --validate %s -o - | FileCheck %s --check-prefix=ONE
// RUN: %clipc -T vs_5_1 -E more --validate %s -o - | FileCheck %s --check-prefix=TWO
struct Nested { float4 b; float pad; };
struct State { float4 a; Nested n; float4 c[3]; row_major float4x4 rows; };
struct Block { float4 plane; };

cbuffer Planes : register(b0) {
  float4 p;
  State s;
  float4 planes[4];
  State sa[2];
  float f;
};
float4 global;
ConstantBuffer<Block> cb : register(b5);
ConstantBuffer<Block> cbs[3] : register(b6);
static const int kIndex = 1;
enum { kTwo = 2 };

// The attribute's name is case-insensitive; other attributes may stand beside it.
[ClipPlanes(p, s.a, s.n.b, planes[2], s.c[kIndex + 1], sa[1].a)]
float4 main(float4 v : POSITION) : SV_Position { return v; }
// ONE: gl_ClipDistance[0] = dot(in_POSITION0, planes.p);
// ONE: gl_ClipDistance[1] = dot(in_POSITION0, planes.s.a);
// ONE: gl_ClipDistance[2] = dot(in_POSITION0, planes.s.n.b);
// ONE: gl_ClipDistance[3] = dot(in_POSITION0, planes.planes[2]);
// ONE: gl_ClipDistance[4] = dot(in_POSITION0, planes.s.c[kIndex + 1]);
// ONE: gl_ClipDistance[5] = dot(in_POSITION0, planes.sa[1].a);

[clipplanes((global), cb.plane, cbs[kTwo].plane, planes[kIndex].rgba, s.rows[1], planes[0].wzyx)]
float4 more(float4 v : POSITION) : SV_Position { return v; }
// TWO: gl_ClipDistance[0] = dot(in_POSITION0, {{.*}}global);
// TWO: gl_ClipDistance[1] = dot(in_POSITION0, cb.plane);
// TWO: gl_ClipDistance[2] = dot(in_POSITION0, cbs[2].plane);
// TWO: gl_ClipDistance[3] = dot(in_POSITION0, planes.planes[kIndex].xyzw);
// TWO: gl_ClipDistance[4] = dot(in_POSITION0, planes.s.rows[1]);
// TWO: gl_ClipDistance[5] = dot(in_POSITION0, planes.planes[0].wzyx);
