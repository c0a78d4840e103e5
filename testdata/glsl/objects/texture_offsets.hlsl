// Offsets of texture reads that are known once loops are unrolled: through locals that are set once, and counters.
// RUN: %clipc -T vs_5_0 --target=glsl450 --verify --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=vulkan --verify --validate %s -o %t.vert
// RUN: %draw compare %s -T vs_5_0 --target glsl450,vulkan
// AUTOUPDATE
Texture2D map;
SamplerState s;
static const int2 kTaps[3] = {int2(-1, 0), int2(0, 2), int2(1, -3)};
static const int kWidth = 2;
float4 Sum(float2 uv) {
  float4 sum = 0;
  int x;
  for (x = kWidth; x > -kWidth; x -= 3) {
    const int2 away[2] = {int2(x, 1), int2(1, x)};
    for (int k = 0; k < 2; ++k) sum += map.SampleLevel(s, uv, 0, away[k]);
  }
  return sum;
}
float4 main(float2 uv : TEXCOORD) : SV_Position {
  int2 o = int2(1, 3) - 2;
  float4 r = Sum(uv) + map.Load(int3(1, 0, 0), o);
  [unroll] for (int y = -1; y <= 1; ++y)
    for (int x = 0; x < 2; x++) r += map.SampleLevel(s, uv, 0, int2(x, y)) * (x + 1);
  for (uint i = 0; i < 3; i++) r += map.Gather(s, uv, kTaps[i]);
  // A loop that no offset depends on stays.
  for (int j = 0; j < 2; ++j) r += map.Gather(s, uv, kTaps[2]);
  return r;
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(binding = 0) uniform sampler2D map;  // t0 with s : s0
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec2 in_TEXCOORD0;  // uv : TEXCOORD0
// CHECK-EMPTY:
// CHECK-NEXT: const int kWidth = 2;
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Sum(vec2 uv) {
// CHECK-NEXT:     vec4 sum = vec4(0.0);
// CHECK-NEXT:     int x;
// CHECK-NEXT:     {
// CHECK-NEXT:         x = kWidth;
// CHECK-NEXT:         {
// CHECK-NEXT:             ivec2 away[2] = ivec2[2](ivec2(2, 1), ivec2(1, 2));
// CHECK-NEXT:             sum += textureLodOffset(map, uv, 0.0, ivec2(2, 1));
// CHECK-NEXT:             sum += textureLodOffset(map, uv, 0.0, ivec2(1, 2));
// CHECK-NEXT:         }
// CHECK-NEXT:         x -= 3;
// CHECK-NEXT:         {
// CHECK-NEXT:             ivec2 away[2] = ivec2[2](ivec2(-1, 1), ivec2(1, -1));
// CHECK-NEXT:             sum += textureLodOffset(map, uv, 0.0, ivec2(-1, 1));
// CHECK-NEXT:             sum += textureLodOffset(map, uv, 0.0, ivec2(1, -1));
// CHECK-NEXT:         }
// CHECK-NEXT:         x -= 3;
// CHECK-NEXT:     }
// CHECK-NEXT:     return sum;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     gl_Position = Sum(in_TEXCOORD0) + texelFetchOffset(map, ivec2(1, 0), 0, ivec2(-1, 1));
// CHECK-NEXT:     {
// CHECK-NEXT:         gl_Position += textureLodOffset(map, in_TEXCOORD0, 0.0, ivec2(0, -1)) * 1.0;
// CHECK-NEXT:         gl_Position += textureLodOffset(map, in_TEXCOORD0, 0.0, ivec2(1, -1)) * 2.0;
// CHECK-NEXT:         gl_Position += textureLodOffset(map, in_TEXCOORD0, 0.0, ivec2(0)) * 1.0;
// CHECK-NEXT:         gl_Position += textureLodOffset(map, in_TEXCOORD0, 0.0, ivec2(1, 0)) * 2.0;
// CHECK-NEXT:         gl_Position += textureLodOffset(map, in_TEXCOORD0, 0.0, ivec2(0, 1)) * 1.0;
// CHECK-NEXT:         gl_Position += textureLodOffset(map, in_TEXCOORD0, 0.0, ivec2(1)) * 2.0;
// CHECK-NEXT:     }
// CHECK-NEXT:     {
// CHECK-NEXT:         gl_Position += textureGatherOffset(map, in_TEXCOORD0, ivec2(-1, 0));
// CHECK-NEXT:         gl_Position += textureGatherOffset(map, in_TEXCOORD0, ivec2(0, 2));
// CHECK-NEXT:         gl_Position += textureGatherOffset(map, in_TEXCOORD0, ivec2(1, -3));
// CHECK-NEXT:     }
// CHECK-NEXT:     for (int j = 0; j < 2; ++j) {
// CHECK-NEXT:         gl_Position += textureGatherOffset(map, in_TEXCOORD0, ivec2(1, -3));
// CHECK-NEXT:     }
// CHECK-NEXT: }
