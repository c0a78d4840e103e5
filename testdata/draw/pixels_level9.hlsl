// OpenGL's own clip planes in the part of Direct3D 9's: the same pixels, from the planes that the clip table names.
// RUN: %clipc -T vs_4_0_level_9_1 -E main --target=glsl120 --depth-range=negative-one-to-one %s -o %t.vert
// RUN: %draw pixels %t.vert --enable 3 --clip-plane 0=1,0.25,-0.5,0.35 --clip-plane 1=0.125,-1,0,0.5 --expect-plane 1,0.25,-0.5,0.35 --expect-plane 0.125,-1,0,0.5
// RUN: not %draw pixels %t.vert --enable 3 --clip-plane 0=1,0.25,-0.5,0.35 --clip-plane 1=0.125,-1,0,0.5 --expect-plane 1,0.25,-0.5,0.35
//
// RUN: %clipc -T vs_4_0_level_9_1 -E main --target=glsl130 --flip-y --depth-range=negative-one-to-one %s -o %t.flip.vert
// RUN: %draw pixels %t.flip.vert --enable 3 --expect-flipped --clip-plane 0=1,0.25,-0.5,0.35 --clip-plane 1=0.125,-1,0,0.5 --expect-plane 1,0.25,-0.5,0.35 --expect-plane 0.125,-1,0,0.5
//
// Nobody sets planes: nothing is clipped.
// RUN: %draw pixels %t.vert

cbuffer Planes {
  float4 first;
  float4 second;
};

[clipplanes(first, second)]
float4 main(float4 position : POSITION) : SV_Position { return position; }
