// Loops that offsets unroll keep their `continue`, `break` and `return`, as fxc's and dxc's do.
// RUN: %draw compare %s -T ps_5_0 -E main
// RUN: %draw compare %s -T ps_6_0 -E ends
// RUN: %draw compare %s -T ps_5_0 -E chosen --target=glsl330,essl300,glsl450,vulkan
// RUN: %clipc -T ps_5_0 %s -o - | FileCheck %s
// RUN: %clipc -T ps_6_0 -E ends %s -o - | FileCheck %s --check-prefix=ENDS
// RUN: %clipc -T ps_5_0 -E main -spirv %s -o %t.spv && spirv-val %t.spv
Texture2D image : register(t0);
SamplerState smooth : register(s0);
SamplerState samplers[2] : register(s1);

// A jump that always happens, or never, leaves no trace.
// CHECK-NOT: continue
// CHECK:      SV_Target0 += textureLodOffset(image, vs_T0, 0.0, ivec2(0, -1))
// CHECK-NEXT: SV_Target0 += textureLodOffset(image, vs_T0, 0.0, ivec2(0, 1))
// CHECK-NOT: continue
float4 main(float2 uv : T) : SV_Target {
  float4 sum = 0;
  [unroll]
  for (int i = -1; i <= 1; i++)
    [unroll]
    for (int j = -1; j <= 1; j++) {
      if (i == 0 && j == 0)
        continue;
      sum += image.SampleLevel(smooth, uv, 0, int2(i, j));
    }
  return sum;
}

float4 Until(float2 uv, float least) {
  float4 sum = 0;
  for (int i = 0; i < 4; i++) {
    float4 texel = image.SampleLevel(smooth, uv, 0, int2(i, -i));
    if (texel.x < least)
      return sum - texel;
    sum += texel;
  }
  return sum;
}

// ENDS:      for (int once = 0; once < 1; once++) {
// ENDS:      bool left
// ENDS:      left{{.*}} = true;
// ENDS-NEXT: break;
float4 ends(float2 uv : T) : SV_Target {
  float4 sum = Until(uv, 0.25);
  int i;
  for (i = 0; i < 3; ++i) {
    float4 texel = image.SampleLevel(smooth, uv, 0, int2(0, i));
    if (texel.x > 0.75)
      continue;
    switch (int(texel.y * 4)) {
      case 0: sum.x += 1; break;
      case 1: sum.y += 2; continue;
      default: sum.z += texel.z; break;
    }
    if (texel.w > 0.5)
      break;
    sum += texel;
  }
  return sum + i;
}

float4 chosen(float2 uv : T) : SV_Target {
  float4 sum = 0;
  for (int i = 0; i < 2; i++) {
    if (uv.x > i)
      continue;
    sum += image.SampleLevel(samplers[i], uv, 0);
    if (i == 1)
      break;
  }
  return sum;
}
