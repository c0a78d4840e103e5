// One dot product for each plane, in operand order, after everything that the shader does.
// RUN: %clipc -T vs_5_0 -E main --depth-range=negative-one-to-one --flip-y --dump-after=lower-clip-planes --stop-after=lower-clip-planes %s | FileCheck %s

cbuffer Planes {
  float4 water;
  float4 portals[2];
};
float4 a, b;

struct Output {
  float2 uv : TEXCOORD0;
  float4 position : SV_Position;
};

[clipplanes(portals[1], water, float4(a.xy, b.zw))]
Output main(float4 position : POSITION) {
  Output result;
  result.position = position;
  result.uv = position.xy;
  if (position.x < 0) {
    result.position.y = 1;
    return result;
  }
  return result;
}

// CHECK: form no-clip-planes
// CHECK: output float clip_distance[3] : SV_ClipDistance0 builtin clip_distance
// CHECK: clip_plane 0 `portals[1]` at Planes+32
// CHECK: clip_plane 1 `water` at Planes+0
// CHECK: main void {{.*}}() {
// CHECK: clip_distance[0u] = dot([[POSITION:[a-zA-Z0-9_.]+]], portals[1
// CHECK-NEXT: clip_distance[1u] = dot([[POSITION]], water)
// CHECK-NEXT: clip_distance[2u] = dot([[POSITION]], float4(a.xy, b.zw))
// CHECK-NEXT: }
