// The last thing that main does, after the distances, which are those of Direct3D's clip space.
// RUN: %clipc -T vs_5_0 -E main --depth-range=negative-one-to-one --flip-y --dump-after=adjust-clip-space --stop-after=adjust-clip-space %s | FileCheck %s --check-prefixes=CHECK,FLIP,DEPTH
// RUN: %clipc -T vs_5_0 -E main --flip-y --dump-after=adjust-clip-space --stop-after=adjust-clip-space %s | FileCheck %s --check-prefixes=CHECK,FLIP
// RUN: %clipc -T vs_5_0 -E main --depth-range=negative-one-to-one --dump-after=adjust-clip-space --stop-after=adjust-clip-space %s | FileCheck %s --check-prefixes=CHECK,DEPTH
// RUN: %clipc -T vs_5_0 -E main --dump-after=adjust-clip-space --stop-after=adjust-clip-space %s | FileCheck %s

cbuffer Planes {
  float4 water;
};

[clipplanes(water)]
float4 main(float4 position : POSITION) : SV_Position { return position; }

// CHECK: form target-clip-space
// CHECK: main void {{.*}}() {
// CHECK: [[POSITION:[a-zA-Z0-9_.]+]] = result
// CHECK-NEXT: clip_distance[0u] = dot(result, water)
// FLIP-NEXT: [[POSITION]].y = -[[POSITION]].y
// DEPTH-NEXT: [[POSITION]].z = (2.0 * [[POSITION]].z) - [[POSITION]].w
// CHECK-NEXT: }
