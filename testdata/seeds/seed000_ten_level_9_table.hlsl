// "User clip planes on feature level 9 hardware", 10Level9 feature levels: beside the shader there is all that it takes to call
// SetClipPlane: for each plane its index, the constant buffer's slot, and where in the buffer it lies.
// RUN: %clipc -T vs_4_0_level_9_3 %s --table=%t.json -o %t.vert
// RUN: FileCheck %s < %t.json
// RUN: not grep -E 'gl_ClipDistance|portal|water' %t.vert

cbuffer Clip : register(b5) {
  float4 unused[2];
  float4 portal;
  float4 water;
};

// CHECK: "enable_mask": 3
// CHECK: "index": 0
// CHECK: "text": "water"
// CHECK: "register": 5
// CHECK: "byte_offset": 48
// CHECK: "index": 1
// CHECK: "text": "portal"
// CHECK: "byte_offset": 32
[clipplanes(water, portal)]
float4 main(float4 position : POSITION) : SV_Position { return position; }
