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
