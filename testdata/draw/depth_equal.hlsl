// A second pass over the same mesh, whose shader writes one output more, draws where its depth is equal to the first pass's. Drivers
// add and multiply in another order where a value is used once; `precise` keeps the order that is written, so that no pixel is lost.
// RUN: %clipc -T vs_5_0 %s -DPRECISE=precise -o %t.first.vert
// RUN: %clipc -T vs_5_0 %s -DPRECISE=precise -DSECOND -o %t.second.vert
// RUN: %draw passes %t.first.vert %t.second.vert | FileCheck %s --check-prefix=ALL
// ALL: 0 of {{[1-9][0-9]*}} pixels of the first pass are missing in the second
//
// -Gis says it of all that the position depends on.
// RUN: %clipc -T vs_5_0 %s -DPRECISE= -Gis -o %t.first.vert
// RUN: %clipc -T vs_5_0 %s -DPRECISE= -Gis -DSECOND -o %t.second.vert
// RUN: %draw passes %t.first.vert %t.second.vert | FileCheck %s --check-prefix=ALL
//
// Without it there are holes; a Mesa that leaves none here needs another shader in this test.
// RUN: %clipc -T vs_5_0 %s -DPRECISE= -o %t.first.vert
// RUN: %clipc -T vs_5_0 %s -DPRECISE= -DSECOND -o %t.second.vert
// RUN: not %draw passes %t.first.vert %t.second.vert | FileCheck %s --check-prefix=HOLES
// HOLES: {{[1-9][0-9]*}} of {{[1-9][0-9]*}} pixels of the first pass are missing in the second
struct Varyings {
  PRECISE float4 position : SV_Position;
#ifdef SECOND
  float2 more : TEXCOORD0;
#endif
};
Varyings main(float4 position : POSITION, float4 offset : TEXCOORD0) {
  Varyings result;
  float height = offset.x * 77 * offset.y;
  float depth = height * 0.3 - offset.x * offset.y * 23 + 0.3;
  result.position = float4(position.xy, depth, 1);
#ifdef SECOND
  result.more = float2(height, offset.x);
#endif
  return result;
}
