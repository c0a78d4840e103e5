// The clip plane in the near plane's place: the kept pixels are those of a user plane, whatever the target's clip space.
// RUN: %clipc -T vs_5_0 --lower=near-plane %s -o %t.vert
// RUN: %draw pixels %t.vert --zero-to-one --expect-any-depth --block Planes@0=0.5,0.125,-0.25,0.175 --expect-plane 0.5,0.125,-0.25,0.175
// RUN: not %draw pixels %t.vert --zero-to-one --expect-any-depth --block Planes@0=0.5,0.125,-0.25,0.175 --expect-plane -0.5,0.125,-0.25,0.175
// RUN: not %draw pixels %t.vert --zero-to-one --block Planes@0=0.5,0.125,-0.25,0.175 --expect-plane 0.5,0.125,-0.25,0.175
// RUN: %clipc -T vs_5_0 --lower=near-plane --depth-range=negative-one-to-one --flip-y %s -o %t.gl.vert
// RUN: %draw pixels %t.gl.vert --expect-any-depth --expect-flipped --block Planes@0=0.5,0.125,-0.25,0.175 --expect-plane 0.5,0.125,-0.25,0.175
//
// A plane that is not scaled reaches the far plane: the contract of "plane_scale": "depth".
// RUN: not %draw pixels %t.vert --zero-to-one --expect-any-depth --block Planes@0=5,1.25,-2.5,1.75 --expect-plane 5,1.25,-2.5,1.75

cbuffer Planes {
  float4 plane;
};

[clipplanes(plane)]
float4 main(float4 position : POSITION) : SV_Position { return position; }
