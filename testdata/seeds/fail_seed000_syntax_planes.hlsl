// "User clip planes on feature level 9 hardware", Syntax: not more than six planes, of type float4, that reside in a constant
// buffer.
// RUN: not %clipc -T vs_4_0 -E seven %s -o - 2>&1 | FileCheck %s --check-prefix=SEVEN
// RUN: not %clipc -T vs_4_0 -E three_components %s -o - 2>&1 | FileCheck %s --check-prefix=TYPE
// RUN: not %clipc -T vs_4_0 -E in_no_buffer %s -o - 2>&1 | FileCheck %s --check-prefix=BUFFER
// RUN: not %clipc -T vs_4_0 -E none %s -o - 2>&1 | FileCheck %s --check-prefix=NONE

cbuffer Clip {
  float4 planes[7];
  float3 normal;
};
static float4 computed;

// SEVEN: error: 7 clip planes given; `clipplanes` takes 1 to 6 [clip-plane-count, X3084]
[clipplanes(planes[0], planes[1], planes[2], planes[3], planes[4], planes[5], planes[6])]
float4 seven(float4 position : POSITION) : SV_Position { return position; }

// TYPE: error: clip plane `normal` has type `float3`; a clip plane is a `float4` [clip-plane-not-float4, X3084]
[clipplanes(normal)]
float4 three_components(float4 position : POSITION) : SV_Position { return position; }

// BUFFER: error: `computed` is not a member of a cbuffer; a clip plane must lie in a constant buffer [clip-plane-not-in-cbuffer, X3084]
[clipplanes(computed)]
float4 in_no_buffer(float4 position : POSITION) : SV_Position { return position; }

// NONE: error: 0 clip planes given; `clipplanes` takes 1 to 6 [clip-plane-count, X3084]
[clipplanes()]
float4 none(float4 position : POSITION) : SV_Position { return position; }
