// What a target or a profile lacks of waves and samples, with the nearest target that has it.
// RUN: not %clipc -T ps_6_6 --target=webgl2 %s -o - 2>&1 | FileCheck %s
// RUN: not %clipc -T ps_5_1 %s -o - 2>&1 | FileCheck %s --check-prefix=PROFILE
// RUN: not %clipc -T ps_6_0 --target=vulkan -E samples %s -o - 2>&1 | FileCheck %s --check-prefix=SAMPLES
// RUN: not %clipc -T ps_6_0 --target=essl320 -E texture %s -o - 2>&1 | FileCheck %s --check-prefix=TEXTURE
float4 main(float4 a : A) : SV_Target {
  // CHECK: [[#@LINE+3]]:10: error: `WaveActiveSum` asks about lanes of the wave; target `webgl2` has no subgroups [target-wave]
  // CHECK: note: target `glsl140` can
  // PROFILE: [[#@LINE+1]]:10: error: `WaveActiveSum` needs profile ps_6_0 or later; this is `ps_5_1` [intrinsic-profile, X4532]
  return WaveActiveSum(a) + WaveGetLaneIndex();
}
// SAMPLES: error: `GetRenderTargetSampleCount` is an input or output that target `vulkan` lacks [target-pixel-value]
// SAMPLES: note: target `glsl400` can
float4 samples(nointerpolation uint n : N) : SV_Target { return GetRenderTargetSamplePosition(n).xyxy; }
Texture2DMS<float4> map;
// TEXTURE: error: the shader queries the number of samples of a texture; target `essl320` cannot answer that [target-texture-query]
// TEXTURE: note: target `glsl450` can
float4 texture(nointerpolation uint n : N) : SV_Target { return map.GetSamplePosition(n).xyxy; }
