// A shader without SV_Position: a later stage writes it, so there is nothing to adjust.
// RUN: %clipc -T vs_5_0 -E main --depth-range=negative-one-to-one --flip-y --dump-after=adjust-clip-space --stop-after=adjust-clip-space %s | FileCheck %s

float4 main(float4 position : POSITION) : WORLD_POSITION { return position; }

// CHECK: form target-clip-space
// CHECK: main void {{.*}}() {
// CHECK-NOT: .z
// CHECK: vs_WORLD_POSITION0 = result
// CHECK-NEXT: }
