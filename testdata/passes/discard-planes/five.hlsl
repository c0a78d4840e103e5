// The pixel shader of a pair discards where one of the distances that the vertex shader writes is below 0, or is not a number.
// RUN: %clipc %s -E vs --pixel-entry=ps --pixel-output=- --lower=discard --dump-after=discard-planes | FileCheck %s
// RUN: %clipc %s -E vs --pixel-entry=ps --lower=discard -o %t.vert --pixel-output=%t.frag --validate
cbuffer Planes { float4 planes[5]; };
[clipplanes(planes[0], planes[1], planes[2], planes[3], planes[4])]
float4 vs(float4 position : POSITION) : SV_Position { return position; }
float4 ps() : SV_Target { return 1; }
// CHECK:      program ps_5_0
// CHECK:      input float4 clip_plane_distance0 : SV_ClipPlaneDistance0
// CHECK-NEXT: input float clip_plane_distance1 : SV_ClipPlaneDistance1
// CHECK:      main void main() {
// CHECK-NEXT:   if ((any(isnan(clip_plane_distance0)) || any(clip_plane_distance0 < zero<float4>)) || (isnan(clip_plane_distance1) || (clip_plane_distance1 < zero<float>))) {
// CHECK-NEXT:     discard
