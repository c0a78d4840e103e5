// Lowered to clip distances, the table names where the host finds each plane in the GLSL; a composed plane has no place.
// RUN: %clipc -T vs_5_0 -E main %s -o %t.vert --table %t.json && FileCheck %s < %t.json

cbuffer Planes {
  float4 planes[2];
};
float4 a, b;

[clipplanes(planes[1], float4(a.xy, b.zw))]
float4 main(float4 position : POSITION) : SV_Position { return position; }

// CHECK: "lowering": "clip-distance",
// CHECK: "enable_mask": 3,
// CHECK: "text": "planes[1]",
// CHECK: "cbuffer": "Planes",
// CHECK: "byte_offset": 16,
// CHECK: "glsl_block": "Planes",
// CHECK: "glsl_member": "Planes.planes[1]"
// CHECK: "index": 1,
// CHECK: "constant": null
