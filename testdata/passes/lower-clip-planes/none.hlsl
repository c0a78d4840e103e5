// The planes are removed from the shader, on request.
// RUN: %clipc -T vs_5_0 -E main --lower=none --dump-after=lower-clip-planes --stop-after=lower-clip-planes %s | FileCheck %s

cbuffer Planes {
  float4 water;
};

[clipplanes(water)]
float4 main(float4 position : POSITION) : SV_Position { return position; }

// CHECK: form no-clip-planes
// CHECK-NOT: clip_distance
// CHECK: main void {{.*}}() {
// CHECK-NOT: water
// CHECK: }
