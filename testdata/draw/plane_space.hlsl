// Clip distances of the other plane spaces, from their definition; and pixels: a plane given for its space clips the same half.
// RUN: %draw compare %s --target all --lower clip-distance --plane-space xyw1 | FileCheck %s
// RUN: %draw compare %s --target all --lower clip-distance --plane-space object | FileCheck %s
// RUN: %draw compare %s --target all --lower clip-distance --plane-space object --position-input CENTRE2 | FileCheck %s
// CHECK: {{[1-9][0-9]+}} comparisons {{.*}}: 0 wrong
//
// The mesh of `pixels` has z = (x + w) / 4 + w / 4 in clip space: 0.5x + 0.125y - 0.25z + 0.175w is
// 0.4375x + 0.125y + 0.05w + 0, in xyw1 (0.4375, 0.125, 0.05, 0); the raw input is the clip position here.
// RUN: %clipc -DPASS --plane-space=xyw1 --depth-range=negative-one-to-one --flip-y %s -o %t.xyw1.vert
// RUN: %draw pixels %t.xyw1.vert --enable 1 --expect-flipped --block Planes@0=0.4375,0.125,0.05,0 --expect-plane 0.4375,0.125,0,0.05
// RUN: not %draw pixels %t.xyw1.vert --enable 1 --expect-flipped --block Planes@0=0.4375,0.125,0,0.05 --expect-plane 0.4375,0.125,0,0.05
// RUN: %clipc -DPASS --plane-space=object --depth-range=negative-one-to-one --flip-y %s -o %t.object.vert
// RUN: %draw pixels %t.object.vert --enable 1 --expect-flipped --block Planes@0=0.5,0.125,-0.25,0.175 --expect-plane 0.5,0.125,-0.25,0.175
// RUN: not %draw pixels %t.object.vert --enable 1 --expect-flipped --block Planes@0=-0.5,0.125,-0.25,0.175 --expect-plane 0.5,0.125,-0.25,0.175
// RUN: %clipc -DPASS --plane-space=object --lower=near-plane --depth-range=negative-one-to-one %s -o %t.near.vert
// RUN: %draw pixels %t.near.vert --expect-any-depth --block Planes@0=0.5,0.125,-0.25,0.175 --expect-plane 0.5,0.125,-0.25,0.175

cbuffer Planes {
  float4 water;
  float4 portals[3];
};
cbuffer Transform {
  float4x4 world, view_projection;
};

#ifdef PASS
[clipplanes(water)]
float4 main(float4 position : POSITION) : SV_Position { return position; }
#else
[clipplanes(portals[2], water, portals[0])]
float4 main(float3 position : POSITION, float4 centre : CENTRE2, out float3 moved : TEXCOORD) : SV_Position {
  const float4 placed = mul(float4(position, 1) + centre, world);
  moved = placed.xyz;
  return mul(placed, view_projection);
}
#endif
