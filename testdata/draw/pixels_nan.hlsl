// A distance that is not a number is outside, whichever of the planes has it; the other planes keep everything.
// RUN: %clipc -T vs_5_0 -DCOUNT=1 --lower=discard --depth-range=negative-one-to-one --fragment=%S/inputs/show.frag %s -o %t.gl1.vert
// RUN: %draw pixels %t.gl1.vert --fragment %t.gl1.frag --block Planes@0=nan,0,0,0 --expect-plane nan,0,0,0
// RUN: %clipc -T vs_5_0 -DCOUNT=2 --lower=discard --depth-range=negative-one-to-one --fragment=%S/inputs/show.frag %s -o %t.gl2.vert
// RUN: %draw pixels %t.gl2.vert --fragment %t.gl2.frag --block Planes@0=nan,0,0,0,0,0,0,1 --expect-plane nan,0,0,0
// RUN: %draw pixels %t.gl2.vert --fragment %t.gl2.frag --block Planes@0=0,0,0,1,nan,0,0,0 --expect-plane nan,0,0,0
// RUN: %clipc -T vs_5_0 -DCOUNT=3 --lower=discard --depth-range=negative-one-to-one --fragment=%S/inputs/show.frag %s -o %t.gl3.vert
// RUN: %draw pixels %t.gl3.vert --fragment %t.gl3.frag --block Planes@0=nan,0,0,0,0,0,0,1,0,0,0,1 --expect-plane nan,0,0,0
// RUN: %draw pixels %t.gl3.vert --fragment %t.gl3.frag --block Planes@0=0,0,0,1,nan,0,0,0,0,0,0,1 --expect-plane nan,0,0,0
// RUN: %draw pixels %t.gl3.vert --fragment %t.gl3.frag --block Planes@0=0,0,0,1,0,0,0,1,nan,0,0,0 --expect-plane nan,0,0,0
// RUN: %clipc -T vs_5_0 -DCOUNT=4 --lower=discard --depth-range=negative-one-to-one --fragment=%S/inputs/show.frag %s -o %t.gl4.vert
// RUN: %draw pixels %t.gl4.vert --fragment %t.gl4.frag --block Planes@0=nan,0,0,0,0,0,0,1,0,0,0,1,0,0,0,1 --expect-plane nan,0,0,0
// RUN: %draw pixels %t.gl4.vert --fragment %t.gl4.frag --block Planes@0=0,0,0,1,nan,0,0,0,0,0,0,1,0,0,0,1 --expect-plane nan,0,0,0
// RUN: %draw pixels %t.gl4.vert --fragment %t.gl4.frag --block Planes@0=0,0,0,1,0,0,0,1,nan,0,0,0,0,0,0,1 --expect-plane nan,0,0,0
// RUN: %draw pixels %t.gl4.vert --fragment %t.gl4.frag --block Planes@0=0,0,0,1,0,0,0,1,0,0,0,1,nan,0,0,0 --expect-plane nan,0,0,0
// RUN: %clipc -T vs_5_0 -DCOUNT=5 --lower=discard --depth-range=negative-one-to-one --fragment=%S/inputs/show.frag %s -o %t.gl5.vert
// RUN: %draw pixels %t.gl5.vert --fragment %t.gl5.frag --block Planes@0=nan,0,0,0,0,0,0,1,0,0,0,1,0,0,0,1,0,0,0,1 --expect-plane nan,0,0,0
// RUN: %draw pixels %t.gl5.vert --fragment %t.gl5.frag --block Planes@0=0,0,0,1,nan,0,0,0,0,0,0,1,0,0,0,1,0,0,0,1 --expect-plane nan,0,0,0
// RUN: %draw pixels %t.gl5.vert --fragment %t.gl5.frag --block Planes@0=0,0,0,1,0,0,0,1,nan,0,0,0,0,0,0,1,0,0,0,1 --expect-plane nan,0,0,0
// RUN: %draw pixels %t.gl5.vert --fragment %t.gl5.frag --block Planes@0=0,0,0,1,0,0,0,1,0,0,0,1,nan,0,0,0,0,0,0,1 --expect-plane nan,0,0,0
// RUN: %draw pixels %t.gl5.vert --fragment %t.gl5.frag --block Planes@0=0,0,0,1,0,0,0,1,0,0,0,1,0,0,0,1,nan,0,0,0 --expect-plane nan,0,0,0
// RUN: %clipc -T vs_5_0 -DCOUNT=6 --lower=discard --depth-range=negative-one-to-one --fragment=%S/inputs/show.frag %s -o %t.gl6.vert
// RUN: %draw pixels %t.gl6.vert --fragment %t.gl6.frag --block Planes@0=nan,0,0,0,0,0,0,1,0,0,0,1,0,0,0,1,0,0,0,1,0,0,0,1 --expect-plane nan,0,0,0
// RUN: %draw pixels %t.gl6.vert --fragment %t.gl6.frag --block Planes@0=0,0,0,1,nan,0,0,0,0,0,0,1,0,0,0,1,0,0,0,1,0,0,0,1 --expect-plane nan,0,0,0
// RUN: %draw pixels %t.gl6.vert --fragment %t.gl6.frag --block Planes@0=0,0,0,1,0,0,0,1,nan,0,0,0,0,0,0,1,0,0,0,1,0,0,0,1 --expect-plane nan,0,0,0
// RUN: %draw pixels %t.gl6.vert --fragment %t.gl6.frag --block Planes@0=0,0,0,1,0,0,0,1,0,0,0,1,nan,0,0,0,0,0,0,1,0,0,0,1 --expect-plane nan,0,0,0
// RUN: %draw pixels %t.gl6.vert --fragment %t.gl6.frag --block Planes@0=0,0,0,1,0,0,0,1,0,0,0,1,0,0,0,1,nan,0,0,0,0,0,0,1 --expect-plane nan,0,0,0
// RUN: %draw pixels %t.gl6.vert --fragment %t.gl6.frag --block Planes@0=0,0,0,1,0,0,0,1,0,0,0,1,0,0,0,1,0,0,0,1,nan,0,0,0 --expect-plane nan,0,0,0
// RUN: %draw pixels %t.gl6.vert --fragment %t.gl6.frag --block Planes@0=0,0,0,1,0,0,0,1,0,0,0,1,0,0,0,1,0,0,0,1,0,0,0,1 --expect-plane 0,0,0,1
// RUN: %clipc -T vs_5_0 -DCOUNT=1 --target=essl100 --lower=discard --depth-range=negative-one-to-one --fragment=%S/inputs/show_es2.frag %s -o %t.es21.vert
// RUN: %draw pixels %t.es21.vert --fragment %t.es21.frag --uniform Planes=nan,0,0,0 --expect-plane nan,0,0,0
// RUN: %clipc -T vs_5_0 -DCOUNT=4 --target=essl100 --lower=discard --depth-range=negative-one-to-one --fragment=%S/inputs/show_es2.frag %s -o %t.es24.vert
// RUN: %draw pixels %t.es24.vert --fragment %t.es24.frag --uniform Planes=nan,0,0,0,0,0,0,1,0,0,0,1,0,0,0,1 --expect-plane nan,0,0,0
// RUN: %draw pixels %t.es24.vert --fragment %t.es24.frag --uniform Planes=0,0,0,1,0,0,0,1,0,0,0,1,nan,0,0,0 --expect-plane nan,0,0,0
// RUN: %clipc -T vs_5_0 -DCOUNT=6 --target=essl100 --lower=discard --depth-range=negative-one-to-one --fragment=%S/inputs/show_es2.frag %s -o %t.es26.vert
// RUN: %draw pixels %t.es26.vert --fragment %t.es26.frag --uniform Planes=nan,0,0,0,0,0,0,1,0,0,0,1,0,0,0,1,0,0,0,1,0,0,0,1 --expect-plane nan,0,0,0
// RUN: %draw pixels %t.es26.vert --fragment %t.es26.frag --uniform Planes=0,0,0,1,0,0,0,1,0,0,0,1,0,0,0,1,0,0,0,1,nan,0,0,0 --expect-plane nan,0,0,0
// RUN: %draw pixels %t.es26.vert --fragment %t.es26.frag --uniform Planes=0,0,0,1,0,0,0,1,0,0,0,1,0,0,0,1,0,0,0,1,0,0,0,1 --expect-plane 0,0,0,1

cbuffer Planes {
  float4 planes[COUNT];
};

#if COUNT == 1
[clipplanes(planes[0])]
#elif COUNT == 2
[clipplanes(planes[0], planes[1])]
#elif COUNT == 3
[clipplanes(planes[0], planes[1], planes[2])]
#elif COUNT == 4
[clipplanes(planes[0], planes[1], planes[2], planes[3])]
#elif COUNT == 5
[clipplanes(planes[0], planes[1], planes[2], planes[3], planes[4])]
#elif COUNT == 6
[clipplanes(planes[0], planes[1], planes[2], planes[3], planes[4], planes[5])]
#endif
float4 main(float4 position : POSITION) : SV_Position { return position; }
