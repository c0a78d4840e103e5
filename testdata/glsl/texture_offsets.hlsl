// Offsets of texture reads that are known once functions are inlined and loops unrolled: through parameters, locals that are set
// once, and counters. A function is written once for each tuple of offsets.
// RUN: %clipc -T vs_5_0 --target=glsl450 --verify --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=vulkan --verify --validate %s -o %t.vert
// RUN: %draw compare %s -T vs_5_0 --target glsl450,vulkan
// AUTOUPDATE
Texture2D map;
SamplerState s;
static const int2 kTaps[3] = {int2(-1, 0), int2(0, 2), int2(1, -3)};
float4 Tap(float2 uv, int2 o) { return map.SampleLevel(s, uv, 0, o); }
float4 Two(float2 uv, int x) { int2 o = int2(x, 1 - x); return Tap(uv, o) + Tap(uv, int2(x, x)) + map.Load(int3(1, 0, 0), o); }
float4 main(float2 uv : TEXCOORD) : SV_Position {
  float4 r = Two(uv, 1) + Two(uv, -1);
  [unroll] for (int y = -1; y <= 1; ++y)
    for (int x = 0; x < 2; x++) r += map.SampleLevel(s, uv, 0, int2(x, y)) * (x + 1) + Tap(uv, int2(y, x));
  for (uint i = 0; i < 3; i++) r += map.Gather(s, uv, kTaps[i]) + Tap(uv, kTaps[i]);
  return r;
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(binding = 0) uniform sampler2D map;  // map with s
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec2 in_TEXCOORD0;  // TEXCOORD0
// CHECK-EMPTY:
// CHECK-NEXT: const ivec2 kTaps[3] = ivec2[3](ivec2(-1, 0), ivec2(0, 2), ivec2(1, -3));
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Tap(vec2 uv, ivec2 o) {
// CHECK-NEXT:     return textureLodOffset(map, uv, 0.0, ivec2(1, 0));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Tap_2(vec2 uv, ivec2 o) {
// CHECK-NEXT:     return textureLodOffset(map, uv, 0.0, ivec2(1));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Two(vec2 uv, int x) {
// CHECK-NEXT:     ivec2 o = ivec2(x, 1 - x);
// CHECK-NEXT:     return Tap(uv, o) + Tap_2(uv, ivec2(x, x)) + texelFetchOffset(map, ivec2(1, 0), 0, ivec2(1, 0));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Tap_3(vec2 uv, ivec2 o) {
// CHECK-NEXT:     return textureLodOffset(map, uv, 0.0, ivec2(-1, 2));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Tap_4(vec2 uv, ivec2 o) {
// CHECK-NEXT:     return textureLodOffset(map, uv, 0.0, ivec2(-1));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Two_2(vec2 uv, int x) {
// CHECK-NEXT:     ivec2 o = ivec2(x, 1 - x);
// CHECK-NEXT:     return Tap_3(uv, o) + Tap_4(uv, ivec2(x, x)) + texelFetchOffset(map, ivec2(1, 0), 0, ivec2(-1, 2));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Tap_5(vec2 uv, ivec2 o) {
// CHECK-NEXT:     return textureLodOffset(map, uv, 0.0, ivec2(-1, 0));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Tap_6(vec2 uv, ivec2 o) {
// CHECK-NEXT:     return textureLodOffset(map, uv, 0.0, ivec2(-1, 1));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Tap_7(vec2 uv, ivec2 o) {
// CHECK-NEXT:     return textureLodOffset(map, uv, 0.0, ivec2(0));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Tap_8(vec2 uv, ivec2 o) {
// CHECK-NEXT:     return textureLodOffset(map, uv, 0.0, ivec2(0, 1));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Tap_9(vec2 uv, ivec2 o) {
// CHECK-NEXT:     return textureLodOffset(map, uv, 0.0, ivec2(0, 2));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Tap_10(vec2 uv, ivec2 o) {
// CHECK-NEXT:     return textureLodOffset(map, uv, 0.0, ivec2(1, -3));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     gl_Position = Two(in_TEXCOORD0, 1) + Two_2(in_TEXCOORD0, -1);
// CHECK-NEXT:     {
// CHECK-NEXT:         int y = -1;
// CHECK-NEXT:         {
// CHECK-NEXT:             {
// CHECK-NEXT:                 int x = 0;
// CHECK-NEXT:                 {
// CHECK-NEXT:                     gl_Position += textureLodOffset(map, in_TEXCOORD0, 0.0, ivec2(0, -1)) * float(x + 1) + Tap_5(in_TEXCOORD0, ivec2(y, x));
// CHECK-NEXT:                 }
// CHECK-NEXT:                 x++;
// CHECK-NEXT:                 {
// CHECK-NEXT:                     gl_Position += textureLodOffset(map, in_TEXCOORD0, 0.0, ivec2(1, -1)) * float(x + 1) + Tap_6(in_TEXCOORD0, ivec2(y, x));
// CHECK-NEXT:                 }
// CHECK-NEXT:                 x++;
// CHECK-NEXT:             }
// CHECK-NEXT:         }
// CHECK-NEXT:         ++y;
// CHECK-NEXT:         {
// CHECK-NEXT:             {
// CHECK-NEXT:                 int x = 0;
// CHECK-NEXT:                 {
// CHECK-NEXT:                     gl_Position += textureLodOffset(map, in_TEXCOORD0, 0.0, ivec2(0)) * float(x + 1) + Tap_7(in_TEXCOORD0, ivec2(y, x));
// CHECK-NEXT:                 }
// CHECK-NEXT:                 x++;
// CHECK-NEXT:                 {
// CHECK-NEXT:                     gl_Position += textureLodOffset(map, in_TEXCOORD0, 0.0, ivec2(1, 0)) * float(x + 1) + Tap_8(in_TEXCOORD0, ivec2(y, x));
// CHECK-NEXT:                 }
// CHECK-NEXT:                 x++;
// CHECK-NEXT:             }
// CHECK-NEXT:         }
// CHECK-NEXT:         ++y;
// CHECK-NEXT:         {
// CHECK-NEXT:             {
// CHECK-NEXT:                 int x = 0;
// CHECK-NEXT:                 {
// CHECK-NEXT:                     gl_Position += textureLodOffset(map, in_TEXCOORD0, 0.0, ivec2(0, 1)) * float(x + 1) + Tap(in_TEXCOORD0, ivec2(y, x));
// CHECK-NEXT:                 }
// CHECK-NEXT:                 x++;
// CHECK-NEXT:                 {
// CHECK-NEXT:                     gl_Position += textureLodOffset(map, in_TEXCOORD0, 0.0, ivec2(1)) * float(x + 1) + Tap_2(in_TEXCOORD0, ivec2(y, x));
// CHECK-NEXT:                 }
// CHECK-NEXT:                 x++;
// CHECK-NEXT:             }
// CHECK-NEXT:         }
// CHECK-NEXT:         ++y;
// CHECK-NEXT:     }
// CHECK-NEXT:     {
// CHECK-NEXT:         uint i = 0u;
// CHECK-NEXT:         {
// CHECK-NEXT:             gl_Position += textureGatherOffset(map, in_TEXCOORD0, ivec2(-1, 0)) + Tap_5(in_TEXCOORD0, kTaps[i]);
// CHECK-NEXT:         }
// CHECK-NEXT:         i++;
// CHECK-NEXT:         {
// CHECK-NEXT:             gl_Position += textureGatherOffset(map, in_TEXCOORD0, ivec2(0, 2)) + Tap_9(in_TEXCOORD0, kTaps[i]);
// CHECK-NEXT:         }
// CHECK-NEXT:         i++;
// CHECK-NEXT:         {
// CHECK-NEXT:             gl_Position += textureGatherOffset(map, in_TEXCOORD0, ivec2(1, -3)) + Tap_10(in_TEXCOORD0, kTaps[i]);
// CHECK-NEXT:         }
// CHECK-NEXT:         i++;
// CHECK-NEXT:     }
// CHECK-NEXT: }
