// Half the screen, a slanted edge, an edge that depends on depth: exactly the kept pixels, whatever the target's clip space.
// RUN: %clipc -T vs_5_0 -E main %s -o %t.vert
// RUN: %draw pixels %t.vert --zero-to-one --enable 3 --block Planes@0=1,0,0,0 --block Planes@16=0,0,0,0 --expect-plane 1,0,0,0
// RUN: %draw pixels %t.vert --zero-to-one --enable 3 --block Planes@0=1,0.25,-0.5,0.35 --block Planes@16=0.125,-1,0,0.5 --expect-plane 1,0.25,-0.5,0.35 --expect-plane 0.125,-1,0,0.5
//
// The opposite half, the planes in the wrong places, a plane less, and the wrong depth range are all seen.
// RUN: not %draw pixels %t.vert --zero-to-one --enable 3 --block Planes@0=1,0,0,0 --block Planes@16=0,0,0,0 --expect-plane -1,0,0,0
// RUN: not %draw pixels %t.vert --zero-to-one --enable 3 --block Planes@0=0,0,0,0 --block Planes@16=0,0,0,0 --expect-plane 1,0,0,0
// RUN: not %draw pixels %t.vert --zero-to-one --enable 1 --block Planes@0=0,0,0,0 --block Planes@16=1,0,0,0 --expect-plane 1,0,0,0
// RUN: not %draw pixels %t.vert --enable 3 --block Planes@0=1,0,0,0 --block Planes@16=0,0,0,0 --expect-plane 1,0,0,0
//
// RUN: %clipc -T vs_5_0 -E main --depth-range=negative-one-to-one %s -o %t.depth.vert
// RUN: %draw pixels %t.depth.vert --enable 3 --block Planes@0=1,0.25,-0.5,0.35 --block Planes@16=0.125,-1,0,0.5 --expect-plane 1,0.25,-0.5,0.35 --expect-plane 0.125,-1,0,0.5
//
// RUN: %clipc -T vs_5_0 -E main --flip-y %s -o %t.flip.vert
// RUN: %draw pixels %t.flip.vert --zero-to-one --enable 3 --expect-flipped --block Planes@0=1,0.25,-0.5,0.35 --block Planes@16=0.125,-1,0,0.5 --expect-plane 1,0.25,-0.5,0.35 --expect-plane 0.125,-1,0,0.5
// RUN: not %draw pixels %t.flip.vert --zero-to-one --enable 3 --block Planes@0=1,0.25,-0.5,0.35 --block Planes@16=0.125,-1,0,0.5 --expect-plane 1,0.25,-0.5,0.35 --expect-plane 0.125,-1,0,0.5
//
// RUN: %clipc -T vs_5_0 -E main --target=essl300 --depth-range=negative-one-to-one --flip-y %s -o %t.es.vert
// RUN: %draw pixels %t.es.vert --enable 3 --expect-flipped --block Planes@0=1,0.25,-0.5,0.35 --block Planes@16=0.125,-1,0,0.5 --expect-plane 1,0.25,-0.5,0.35 --expect-plane 0.125,-1,0,0.5

cbuffer Planes {
  float4 first;
  float4 second;
};

[clipplanes(first, second)]
float4 main(float4 position : POSITION) : SV_Position { return position; }
