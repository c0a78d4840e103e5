// A loop whose counter is in an offset is unrolled: each body has the counter's value, without what that value decides. A counter that
// is declared before the loop keeps its last value.
// RUN: %clipc -T ps_5_0 --verify --validate %s -o - | FileCheck %s
// RUN: %draw compare %s -T ps_5_0 --target glsl450,vulkan
// AUTOUPDATE
Texture2D map;
SamplerState s;
static const float kWeights[3] = {0.25, 0.5, 0.25};
float4 main(float2 uv : UV) : SV_Target {
  float4 sum = 0;
  [unroll] for (int x = -1; x <= 1; ++x) {
    float weight = kWeights[x + 1];
    if (x == 0) weight *= 2;
    sum += map.SampleLevel(s, uv, 0, int2(x, 0)) * weight * (x - 1);
  }
  int y;
  for (y = 0; y < 2; ++y) sum += map.SampleLevel(s, uv, 0, int2(0, y));
  return sum * y;
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(binding = 16) uniform sampler2D map;  // t0 with s : s0
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec2 vs_UV0;  // uv : UV0
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) out vec4 SV_Target0;  // main : SV_Target0
// CHECK-EMPTY:
// CHECK-NEXT: const float kWeights[3] = float[3](0.25, 0.5, 0.25);
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     vec4 sum = vec4(0.0);
// CHECK-NEXT:     {
// CHECK-NEXT:         {
// CHECK-NEXT:             float weight = kWeights[0];
// CHECK-NEXT:             sum += textureLodOffset(map, vs_UV0, 0.0, ivec2(-1, 0)) * weight * -2.0;
// CHECK-NEXT:         }
// CHECK-NEXT:         {
// CHECK-NEXT:             float weight = kWeights[1];
// CHECK-NEXT:             weight *= 2.0;
// CHECK-NEXT:             sum += textureLodOffset(map, vs_UV0, 0.0, ivec2(0)) * weight * -1.0;
// CHECK-NEXT:         }
// CHECK-NEXT:         {
// CHECK-NEXT:             float weight = kWeights[2];
// CHECK-NEXT:             sum += textureLodOffset(map, vs_UV0, 0.0, ivec2(1, 0)) * weight * 0.0;
// CHECK-NEXT:         }
// CHECK-NEXT:     }
// CHECK-NEXT:     int y;
// CHECK-NEXT:     {
// CHECK-NEXT:         y = 0;
// CHECK-NEXT:         sum += textureLodOffset(map, vs_UV0, 0.0, ivec2(0));
// CHECK-NEXT:         ++y;
// CHECK-NEXT:         sum += textureLodOffset(map, vs_UV0, 0.0, ivec2(0, 1));
// CHECK-NEXT:         ++y;
// CHECK-NEXT:     }
// CHECK-NEXT:     SV_Target0 = sum * float(y);
// CHECK-NEXT: }
