// Factors and distances that nothing writes are named one by one, as every output is (fxc's X3578).
// RUN: %clipc %s -T hs_5_0 -E never -o %t.tesc 2>&1 | FileCheck %s --check-prefixes=FIELDS,NEVER
// RUN: %clipc %s -T hs_5_0 -E limited -o %t.tesc 2>&1 | FileCheck %s --check-prefix=FIELDS
// RUN: %clipc %s -T hs_5_0 -E choice -o %t.tesc 2>&1 | FileCheck %s --check-prefix=CHOICE
// RUN: %clipc %s -T hs_5_0 -E looped -Werror -o %t.tesc 2>&1 | count 0
// RUN: %clipc %s -T vs_5_0 -E clipped -Wno-clip-distances-left-out -o %t.vert 2>&1 | FileCheck %s --check-prefix=CLIPPED
struct P { float4 p : POSITION; };
struct C {
  // FIELDS: [[#@LINE+1]]:16: warning: the output `SV_TessFactor[1]` is never written; the next stage reads what is undefined [-Woutput-not-written]
  float f[3] : SV_TessFactor;
  // FIELDS: [[#@LINE+1]]:13: warning: the output `SV_InsideTessFactor[0]` is never written; the next stage reads what is undefined [-Woutput-not-written]
  float i : SV_InsideTessFactor;
  // NEVER: [[#@LINE+1]]:18: warning: the output `color` is never written; the next stage reads what is undefined [-Woutput-not-written]
  float4 color : COLOR;
};
float level;
C Never() { C c; c.f[0] = level; c.f[2] = level; return c; }
C Looped() { C c; for (int k = 0; k < 3; ++k) c.f[k] = level; c.i = level; c.color = level; return c; }
// CHOICE: [[#@LINE+1]]:30: warning: the output `SV_TessFactor[1]` is not written on every path; where it is not, its value is undefined [-Woutput-not-always-written]
void Choice(out float f[3] : SV_TessFactor, out float i : SV_InsideTessFactor) {
  f[0] = f[2] = i = 1;
  if (level > 2) f[1] = level;
}
#define HS(function) [domain("tri")] [partitioning("integer")] [outputtopology("triangle_cw")] [outputcontrolpoints(3)] [patchconstantfunc(function)]
HS("Never") P never(InputPatch<P, 3> v) { return v[0]; }
HS("Never") [maxtessfactor(8)] P limited(InputPatch<P, 3> v) { return v[0]; }
HS("Choice") P choice(InputPatch<P, 3> v) { return v[0]; }
HS("Looped") P looped(InputPatch<P, 3> v) { return v[0]; }
struct V {
  float4 p : SV_Position;
  // CLIPPED: [[#@LINE+1]]:17: warning: the output `SV_ClipDistance[1]` is never written; the next stage reads what is undefined [-Woutput-not-written]
  float2 clip : SV_ClipDistance;
};
V clipped(float4 p : POSITION) { V v; v.p = p; v.clip.x = p.x; return v; }
