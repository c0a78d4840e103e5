// The plane becomes the depth, in Direct3D's clip space: before the depth range and y are changed.
// RUN: %clipc -T vs_5_0 --lower=near-plane --depth-range=negative-one-to-one --flip-y --validate %s -o - --table %t.json | FileCheck %s
// RUN: FileCheck %s --check-prefix=TABLE --input-file %t.json
float4 water;

[clipplanes(water)]
float4 main(float4 position : POSITION) : SV_Position { return position; }

// CHECK-NOT: gl_ClipDistance
// CHECK: vec4 result = in_POSITION0;
// CHECK-NEXT: result.z = dot(result, globals.water);
// CHECK-NEXT: gl_Position = result;
// CHECK-NEXT: gl_Position.y = -gl_Position.y;
// CHECK-NEXT: gl_Position.z = 2.0 * gl_Position.z - gl_Position.w;
// CHECK-NEXT: }

// TABLE: "lowering": "near-plane"
// TABLE: "plane_scale": "depth"
// TABLE: "enable_mask": 0
