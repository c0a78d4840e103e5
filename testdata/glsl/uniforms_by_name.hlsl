// Before uniform blocks, members are uniform variables that the host sets by name; only those that are read.
// RUN: %clipc -T vs_5_0 --target=glsl120 --validate %s -o - --reflect %t.json | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=glsl130 --validate %s -o %t
// AUTOUPDATE
struct Light {
  float3 color;
  float intensity;
};
cbuffer Frame {
  float x;
  float3 y;
  float4x4 world;
  row_major float4x4 view;
  Light lights[2];
  float4 unused;
  bool fog;
}

float4 main(float4 p : POSITION) : SV_Position {
  float4 r = mul(mul(p, world), view) + x * y.xyzx + lights[1].color.xyzx * lights[0].intensity;
  return fog ? r : p;
}
