// Offsets that are parameters: a function is copied for the constants of its calls. fxc inlines every call, so its listing of FXAA 1.0
// in DXDecompiler's tests has the constants as offsets.
// RUN: %clipc -T vs_5_0 --target=glsl450 --verify --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=vulkan --verify --validate %s -o %t.vert
// RUN: %draw compare %s -T vs_5_0 --target glsl450,vulkan
// AUTOUPDATE
Texture2D map;
SamplerState s;
float4 Near(float2 uv, int2 away, float scale) { return map.SampleLevel(s, uv, 0, away) * scale; }
float4 Row(float2 uv, int y) {
  float4 sum = 0;
  for (int x = -1; x < 1; ++x) sum += Near(uv, int2(x, y), x + 2);
  return sum;
}
float4 main(float2 uv : TEXCOORD, float scale : SCALE) : SV_Position {
  // Two calls with the same constant have one copy.
  return Row(uv, 1) + Row(uv, -2) + Near(uv, int2(0, 1), scale) + Near(uv.yx, int2(0, 1), 0.5);
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(binding = 0) uniform sampler2D map;  // t0 with s : s0
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec2 in_TEXCOORD0;  // uv : TEXCOORD0
// CHECK-NEXT: layout(location = 1) in float in_SCALE0;  // scale : SCALE0
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Near(vec2 uv, float scale) {
// CHECK-NEXT:     return textureLodOffset(map, uv, 0.0, ivec2(-1, 1)) * scale;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Near_2(vec2 uv, float scale) {
// CHECK-NEXT:     return textureLodOffset(map, uv, 0.0, ivec2(0, 1)) * scale;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Row(vec2 uv) {
// CHECK-NEXT:     vec4 sum = vec4(0.0);
// CHECK-NEXT:     {
// CHECK-NEXT:         sum += Near(uv, 1.0);
// CHECK-NEXT:         sum += Near_2(uv, 2.0);
// CHECK-NEXT:     }
// CHECK-NEXT:     return sum;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Near_3(vec2 uv, float scale) {
// CHECK-NEXT:     return textureLodOffset(map, uv, 0.0, ivec2(-1, -2)) * scale;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Near_4(vec2 uv, float scale) {
// CHECK-NEXT:     return textureLodOffset(map, uv, 0.0, ivec2(0, -2)) * scale;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Row_2(vec2 uv) {
// CHECK-NEXT:     vec4 sum = vec4(0.0);
// CHECK-NEXT:     {
// CHECK-NEXT:         sum += Near_3(uv, 1.0);
// CHECK-NEXT:         sum += Near_4(uv, 2.0);
// CHECK-NEXT:     }
// CHECK-NEXT:     return sum;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     gl_Position = Row(in_TEXCOORD0) + Row_2(in_TEXCOORD0) + Near_2(in_TEXCOORD0, in_SCALE0) + Near_2(in_TEXCOORD0.yx, 0.5);
// CHECK-NEXT: }
