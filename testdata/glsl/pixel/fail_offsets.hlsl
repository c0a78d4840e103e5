// GLSL before 1.30 reads no texture at an offset, whatever gives the level.
// RUN: not %clipc -T ps_5_0 -E plain --target=glsl120 %s -o - 2>&1 | FileCheck %s
// RUN: not %clipc -T ps_5_0 -E biased --target=essl100 %s -o - 2>&1 | FileCheck %s --check-prefix=BIASED
// RUN: not %clipc -T ps_5_0 -E graded --target=glsl120 %s -o - 2>&1 | FileCheck %s --check-prefix=GRADED
Texture2D map;
SamplerState linearly;
float4 plain(float2 uv : UV) : SV_Target { return map.Sample(linearly, uv, int2(1, -1)); }
// CHECK: error: a texture is read at an offset; target `glsl120` has no function for that [target-sample-offset]
float4 biased(float2 uv : UV) : SV_Target { return map.SampleBias(linearly, uv, 1, int2(1, -1)); }
// BIASED: error: a texture is read at an offset; target `essl100` has no function for that [target-sample-offset]
float4 graded(float2 uv : UV) : SV_Target { return map.SampleGrad(linearly, uv, uv, uv, int2(1, -1)); }
// GRADED: error: a texture is read at an offset; target `glsl120` has no function for that [target-sample-offset]
