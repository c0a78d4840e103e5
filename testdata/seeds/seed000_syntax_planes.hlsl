// "User clip planes on feature level 9 hardware", Syntax: the attribute names float4 constants of a constant buffer, up to
// six, right before the function's return type; the function itself does not know of them.
// RUN: %clipc -T vs_4_0 -E main --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_4_0 -E six --validate %s -o - | FileCheck %s --check-prefix=SIX

cbuffer Clip : register(b3) {
  float4 near_water;
  float4 behind_portal;
  float4 more[4];
};

// The rest is as it would be without the attribute.
// CHECK: void main() {
// CHECK-NOT: near_water
// CHECK: gl_Position =
// CHECK-NEXT: gl_ClipDistance[0] = dot(in_POSITION0, clip.near_water);
// CHECK-NEXT: gl_ClipDistance[1] = dot(in_POSITION0, clip.behind_portal);
// CHECK-NOT: gl_ClipDistance
[clipplanes(near_water, behind_portal)]
float4 main(float4 position : POSITION) : SV_Position { return position; }

// SIX: gl_ClipDistance[0] = dot(in_POSITION0, clip.more[3]);
// SIX: gl_ClipDistance[5] = dot(in_POSITION0, clip.near_water);
[clipplanes(more[3], more[2], more[1], more[0], behind_portal, near_water)]
float4 six(float4 position : POSITION) : SV_Position { return position; }
