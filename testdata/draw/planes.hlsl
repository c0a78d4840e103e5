// Six planes in every kind of place, for every target and way of lowering.
// RUN: %draw compare %s -T vs_5_0 -E main --target all | FileCheck %s
// CHECK: {{[1-9][0-9]+}} comparisons {{.*}}: 0 wrong
// CHECK: left out: glsl120 clip-distance

cbuffer Transform {
  float4x4 world;
  float4x4 view_projection;
};
struct Side {
  float distance;
  float4 plane;
};
cbuffer Planes {
  float4 water;
  float4 portals[3];
  Side sides[2];
  float4 last;
};
float4 loose;

[clipplanes(portals[2], water, sides[1].plane, loose, portals[0], last.xyzw)]
float4 main(float3 position : POSITION) : SV_Position {
  return mul(mul(float4(position, 1), world), view_projection);
}
