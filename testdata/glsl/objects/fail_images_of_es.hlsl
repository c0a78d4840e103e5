// Images that OpenGL ES does not have.
// RUN: not %clipc %s -T ps_5_0 -E format --target=essl320 -o - 2>&1 | FileCheck %s --check-prefix=FORMAT
// RUN: not %clipc %s -T ps_5_0 -E both --target=essl310 -o - 2>&1 | FileCheck %s --check-prefix=BOTH
// RUN: not %clipc %s -T ps_5_0 -E ramps --target=essl320 -o - 2>&1 | FileCheck %s --check-prefix=RAMP
// RUN: not %clipc %s -T ps_5_0 -E both --target=webgl2 -o - 2>&1 | FileCheck %s --check-prefix=WEB
// RUN: not %clipc %s -T ps_5_0 -E list --target=essl310 -o - 2>&1 | FileCheck %s --check-prefix=LIST
// RUN: not %clipc %s -T ps_5_0 -E list --target=essl320 -o - 2>&1 | FileCheck %s --check-prefix=LIST
RWTexture2D<float2> pairs : register(u1);
RWTexture2D<float4> colors : register(u2);
RWTexture1D<uint> ramp : register(u3);
// FORMAT: [[#@LINE-3]]:21: error: the image `pairs` has the format `rg32f`; target `essl320` has no such images [target-image-format]
// FORMAT: note: target `glsl420` can
float4 format(float2 p : P) : SV_Target { pairs[int2(p)] = p; return 0; }
// BOTH: [[#@LINE-5]]:21: error: the image `colors` is read and written with the format `rgba32f`, not one component of 32 bits; target `essl310` has no such images [target-image-format]
// WEB: [[#@LINE-6]]:21: error: `colors` is writable; clipc does not translate that for target `webgl2`, only for GLSL from 4.20 on, ES from 3.10 on and Vulkan [target-image]
float4 both(float2 p : P) : SV_Target { colors[int2(p)] *= 2; return 0; }
// RAMP: [[#@LINE-7]]:19: error: `ramp` is a one-dimensional texture; target `essl320` has none [target-texture1-d]
float4 ramps(float2 p : P) : SV_Target { ramp[int(p.x)] = 1; return 0; }
// LIST: [[#@LINE+1]]:18: error: the image `values` is read and written with the format `rgba32f`, not one component of 32 bits; target `essl3{{.*}}` has no such images [target-image-format]
RWBuffer<float4> values : register(u4);
float4 list(float2 p : P) : SV_Target {
  float4 v = values[1];
  values[2] = v * 2;
  return v;
}
