// Discarded in the fragment shader: the same pixels as with clip distances.
// RUN: %clipc -T vs_5_0 --lower=discard --fragment=%S/inputs/show.frag %s -o %t.vert
// RUN: %draw pixels %t.vert --fragment %t.frag --zero-to-one --block Planes@0=1,0.25,-0.5,0.35 --block Planes@16=0.125,-1,0,0.5 --expect-plane 1,0.25,-0.5,0.35 --expect-plane 0.125,-1,0,0.5
// RUN: not %draw pixels %t.vert --fragment %t.frag --zero-to-one --block Planes@0=1,0.25,-0.5,0.35 --block Planes@16=0.125,-1,0,0.5 --expect-plane 1,0.25,-0.5,0.35
// RUN: %clipc -T vs_5_0 --lower=discard --flip-y --depth-range=negative-one-to-one --fragment=%S/inputs/show.frag %s -o %t.gl.vert
// RUN: %draw pixels %t.gl.vert --fragment %t.gl.frag --expect-flipped --block Planes@0=1,0.25,-0.5,0.35 --block Planes@16=0.125,-1,0,0.5 --expect-plane 1,0.25,-0.5,0.35 --expect-plane 0.125,-1,0,0.5
// RUN: %clipc -T vs_5_0 --target=essl100 --lower=discard --depth-range=negative-one-to-one --fragment=%S/inputs/show_es2.frag %s -o %t.es2.vert
// RUN: %draw pixels %t.es2.vert --fragment %t.es2.frag --uniform Planes=1,0.25,-0.5,0.35,0.125,-1,0,0.5 --expect-plane 1,0.25,-0.5,0.35 --expect-plane 0.125,-1,0,0.5
// RUN: not %draw pixels %t.es2.vert --fragment %t.es2.frag --uniform Planes=1,0.25,-0.5,0.35,0.125,-1,0,0.5 --expect-plane 1,0.25,-0.5,0.35

cbuffer Planes {
  float4 first;
  float4 second;
};

[clipplanes(first, second)]
float4 main(float4 position : POSITION) : SV_Position { return position; }
