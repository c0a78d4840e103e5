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

// CHECK: #version 120
// CHECK-EMPTY:
// CHECK-NEXT: struct Light {
// CHECK-NEXT:     vec3 color;
// CHECK-NEXT:     float intensity;
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: // Frame, b0
// CHECK-NEXT: uniform float x;
// CHECK-NEXT: uniform vec3 y;
// CHECK-NEXT: uniform mat4 world;
// CHECK-NEXT: uniform mat4 view;
// CHECK-NEXT: uniform Light lights[2];
// CHECK-NEXT: uniform bool fog;
// CHECK-EMPTY:
// CHECK-NEXT: attribute vec4 in_POSITION0;  // p : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     vec4 r = view * (world * in_POSITION0) + x * y.xyzx + lights[1].color.xyzx * lights[0].intensity;
// CHECK-NEXT:     gl_Position = fog ? r : in_POSITION0;
// CHECK-NEXT: }
