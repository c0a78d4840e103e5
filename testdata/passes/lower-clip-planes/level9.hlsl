// The shader computes no distance; a target with gl_ClipVertex gets the position as the shader wrote it.
// RUN: %clipc -T vs_4_0_level_9_1 -E main --target=glsl450 --dump-after=lower-clip-planes --stop-after=lower-clip-planes %s | FileCheck %s --check-prefixes=CHECK,TABLE
// RUN: %clipc -T vs_4_0_level_9_1 -E main --target=glsl120 --dump-after=lower-clip-planes --stop-after=lower-clip-planes %s | FileCheck %s --check-prefixes=CHECK,VERTEX
// RUN: %clipc -T vs_5_0 -E main --lower=level9 --target=glsl130 --dump-after=lower-clip-planes --stop-after=lower-clip-planes %s | FileCheck %s --check-prefixes=CHECK,VERTEX

cbuffer Planes {
  float4 water;
  float4 portals[2];
};

[clipplanes(portals[1], water)]
float4 main(float4 position : POSITION) : SV_Position { return position; }

// CHECK: form no-clip-planes
// CHECK-NOT: clip_distance
// VERTEX: output float4 clip_vertex builtin clip_vertex
// CHECK: clip_plane 0 `portals[1]` at Planes+32
// CHECK: clip_plane 1 `water` at Planes+0
// CHECK: main void {{.*}}() {
// CHECK-NOT: dot(
// VERTEX: clip_vertex = {{[a-zA-Z0-9_.]+$}}
// TABLE-NOT: clip_vertex
// CHECK-NOT: {{portals|water}}
// CHECK: }
