// Places of samples are Direct3D's standard patterns, in sixteenths of a pixel from its centre; a place that no sample has is 0.
// Oracle: the table of D3D11_STANDARD_MULTISAMPLE_PATTERN in the Direct3D 11.3 functional specification, 19.2.4.1; samplepos there gives
// 0 out of range.
// RUN: %clipc -T ps_5_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T ps_5_0 --target=vulkan --validate %s -o %t
// RUN: %clipc -T ps_5_0 -E target --validate %s -o - | FileCheck %s --check-prefix=TARGET
// RUN: %clipc -T ps_5_0 -E target --target=essl320 --validate %s -o %t
Texture2DMS<float4> map;
// CHECK: const vec2 sample_positions[31] = vec2[31](vec2(0.0), vec2(0.25), vec2(-0.25), vec2(-0.125, -0.375),
float4 main(nointerpolation uint n : N) : SV_Target {
  // CHECK: = uint(textureSamples(map));
  // CHECK: < {{.*}} && {{.*}} <= 16u ? sample_positions[{{.*}} - 1u + {{.*}}] : vec2(0.0);
  float2 p = map.GetSamplePosition(n);
  return p.xyxy;
}
float4 target(nointerpolation uint n : N) : SV_Target {
  // TARGET: = uint(gl_NumSamples);
  float2 p = GetRenderTargetSamplePosition(n);
  return float4(p, GetRenderTargetSampleCount(), 1);
}
