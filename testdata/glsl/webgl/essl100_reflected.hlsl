// OpenGL ES 2 has no blocks: the buffer is an array of rows, and what is not of floats is beside it; --blocks=flat makes
// uniforms of all. The table names the row of a plane.
// RUN: %clipc -T vs_5_0 --target=essl100 --lower=none --validate %s -o %t.vert --reflect %t.json --table %t.table.json
// RUN: FileCheck %s --check-prefix=GLSL --input-file %t.vert
// RUN: FileCheck %s --input-file %t.json
// RUN: FileCheck %s --check-prefix=TABLE --input-file %t.table.json
// RUN: %clipc -T vs_5_0 --target=essl100 --lower=none --blocks=flat --validate %s -o %t.flat.vert --reflect %t.flat.json
// RUN: FileCheck %s --check-prefix=FLAT --input-file %t.flat.vert
// RUN: FileCheck %s --check-prefix=FLAT-JSON --input-file %t.flat.json
// RUN: %draw compare %s -T vs_5_0 --target essl100 --lower none --ints 0..1
cbuffer Frame {
  float4 plane;
  float4x4 world;
  int2 counts;
  int2x2 grid[2];
  float4 unread;
};

[clipplanes(plane)]
float4 main(float4 p : POSITION, int i : I) : SV_Position {
  return mul(p, world) + counts.xyxy + grid[i][1].xyxy;
}

// GLSL: uniform vec4 Frame[5];  // b0
// GLSL-NEXT: uniform ivec2 counts;
// GLSL-NEXT: uniform ivec2_array2 grid[2];
// GLSL-NOT: plane

// CHECK: "size": 176,
// CHECK-NEXT: "used": true,
// CHECK-NEXT: "glsl": {
// CHECK-NEXT:   "layout": "rows",
// CHECK-NEXT:   "rows": "Frame"
// CHECK-NEXT: },
// CHECK: "name": "world",
// CHECK-NEXT: "type": "float4x4",
// CHECK-NEXT: "offset": 16,
// CHECK-NEXT: "size": 64,
// CHECK-NEXT: "glsl": "world"
// CHECK: "name": "counts",
// CHECK: "glsl": "counts",
// CHECK-NEXT: "uniform": true,

// TABLE: "glsl_member": "Frame[0]"

// FLAT: uniform mat4 world;
// FLAT-NEXT: uniform ivec2 counts;
// FLAT-JSON: "glsl": "world",
// FLAT-JSON-NEXT: "transpose": true
