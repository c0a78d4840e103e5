// RUN: not %clipc -T vs_5_0 %s -o - 2>&1 | FileCheck %s
// RUN: %clipc -T vs_5_0 -E eight %s -o - 2>&1 | FileCheck %s --check-prefix=EIGHT
// RUN: %clipc -T vs_5_0 %s -o - --lower=none 2>&1 | FileCheck %s --check-prefix=NONE
// Clip planes and cull distances share eight distances.
cbuffer Planes { float4 p[6]; };
struct Out {
  float4 position : SV_Position;
  // CHECK: fail_too_many.hlsl:[[#@LINE+4]]:13: error: 9 clip and cull distances are written; the limit is 8 [too-many-clip-distances, X4567]
  // CHECK: :[[#@LINE+1]]:18: note: cull distances are written here
  float3 culls : SV_CullDistance0;
};
[clipplanes(p[0], p[1], p[2], p[3], p[4], p[5])]
Out main(float4 v : POSITION) {
  Out o;
  o.position = v;
  o.culls = v.xyz;
  return o;
}
// NONE-NOT: error:
// EIGHT-NOT: error:
// EIGHT: gl_ClipDistance[4] =
[clipplanes(p[0], p[1], p[2], p[3], p[4])]
Out eight(float4 v : POSITION) { return main(v); }
