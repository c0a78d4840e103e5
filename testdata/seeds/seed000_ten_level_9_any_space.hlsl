// "User clip planes on feature level 9 hardware", 10Level9 feature levels: in Direct3D 10 a plane may be in any space. Right of
// SV_ClipDistance, which the shader computes itself; the planes of [clipplanes] are in clip space at every level.
// RUN: %clipc -T vs_5_0 -E in_world_space --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 -E in_clip_space --validate %s -o - | FileCheck %s --check-prefix=CLIP

cbuffer Scene {
  row_major float4x4 world;
  row_major float4x4 view_projection;
  float4 plane;
};

struct Output {
  float4 position : SV_Position;
  float distance : SV_ClipDistance;
};

// CHECK: in_world = {{.*}}world *
// CHECK: dot(in_world, {{.*}}plane);
// CHECK: gl_ClipDistance[0] =
Output in_world_space(float4 position : POSITION) {
  Output output;
  float4 in_world = mul(position, world);
  output.position = mul(in_world, view_projection);
  output.distance = dot(in_world, plane);
  return output;
}

// CLIP: gl_ClipDistance[0] = dot(result, scene.plane);
[clipplanes(plane)]
float4 in_clip_space(float4 position : POSITION) : SV_Position { return mul(mul(position, world), view_projection); }
