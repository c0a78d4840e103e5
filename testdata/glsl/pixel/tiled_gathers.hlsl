// Four gathers with a status as a part of a statement: the texel of the first one is declared before it.
// RUN: %clipc %s -T ps_5_0 --target=vulkan --validate -o - 2>&1 | FileCheck %s
// RUN: %clipc %s -T ps_5_0 -spirv -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// CHECK-NOT: warning
// CHECK: vec4 [[TEXEL:[a-z_0-9]+]];
// CHECK-NEXT: {{.*}}sparseTextureGatherOffsetARB(sampler2D(map, soft), vs_UV0, vs_A0, [[TEXEL]])
Texture2D map;
SamplerState soft;
float4 main(float2 uv : UV, nointerpolation int2 a : A) : SV_Target {
  uint status;
  float4 sum = 0;
  sum += map.GatherRed(soft, uv, a, a, a, a, status);
  return sum * status;
}
