// "User clip planes on feature level 9 hardware", Syntax, Note: two ways to switch a plane off. The otherwise identical shader
// without the attribute, which --lower=none makes of this one; and coefficients of zero.
// RUN: %clipc -T vs_4_0 --target=glsl450 --depth-range=negative-one-to-one %s -D PLANES -o %t.planes.vert
// RUN: %clipc -T vs_4_0 --target=glsl450 --depth-range=negative-one-to-one %s -o %t.without.vert
// RUN: %clipc -T vs_4_0 --target=glsl450 --depth-range=negative-one-to-one %s -D PLANES --lower=none -Wno-clip-planes-ignored -o %t.none.vert
// RUN: diff %t.without.vert %t.none.vert
// RUN: %draw pixels %t.planes.vert --enable 1 --block Clip@0=1,0,0,0 --expect-plane 1,0,0,0
// RUN: not %draw pixels %t.planes.vert --enable 1 --block Clip@0=1,0,0,0
// RUN: %draw pixels %t.planes.vert --enable 1 --block Clip@0=0,0,0,0
// RUN: %draw pixels %t.without.vert

cbuffer Clip { float4 plane; };

#ifdef PLANES
[clipplanes(plane)]
#endif
float4 main(float4 position : POSITION) : SV_Position { return position; }
