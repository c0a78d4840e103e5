// packoffset leaves gaps: explicit offsets where the target has them, else padding members. The order is that of the offsets.
// RUN: %clipc -T vs_5_0 --target=glsl440 --validate %s -o - | FileCheck %s --check-prefix=OFFSET
// RUN: %clipc -T vs_5_0 --target=glsl430 --validate %s -o - | FileCheck %s --check-prefix=PADDING
// RUN: %clipc -T vs_5_0 --target=essl300 --validate %s -o %t
// AUTOUPDATE
cbuffer Old {
  float4 late : packoffset(c5);
  float2 high : packoffset(c3.z);
  float early : packoffset(c0.y);
};

float4 main(float4 p : POSITION) : SV_Position { return p * late + high.xyxy + early; }

// OFFSET: #version 440
// OFFSET-EMPTY:
// OFFSET-NEXT: layout(std140, binding = 0) uniform Old {  // b0
// OFFSET-NEXT:     layout(offset = 4) float early;
// OFFSET-NEXT:     layout(offset = 56) vec2 high;
// OFFSET-NEXT:     layout(offset = 80) vec4 late;
// OFFSET-NEXT: } old;
// OFFSET-EMPTY:
// OFFSET-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// OFFSET-EMPTY:
// OFFSET-NEXT: void main() {
// OFFSET-NEXT:     gl_Position = in_POSITION0 * old.late + old.high.xyxy + old.early;
// OFFSET-NEXT: }

// PADDING: #version 430
// PADDING-EMPTY:
// PADDING-NEXT: layout(std140, binding = 0) uniform Old {  // b0
// PADDING-NEXT:     float padding_0;
// PADDING-NEXT:     float early;
// PADDING-NEXT:     float padding_8;
// PADDING-NEXT:     float padding_12;
// PADDING-NEXT:     vec4 padding_16[2];
// PADDING-NEXT:     float padding_48;
// PADDING-NEXT:     float padding_52;
// PADDING-NEXT:     vec2 high;
// PADDING-NEXT:     vec4 padding_64;
// PADDING-NEXT:     vec4 late;
// PADDING-NEXT: } old;
// PADDING-EMPTY:
// PADDING-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// PADDING-EMPTY:
// PADDING-NEXT: void main() {
// PADDING-NEXT:     gl_Position = in_POSITION0 * old.late + old.high.xyxy + old.early;
// PADDING-NEXT: }
