// Comparisons that GLSL has no function for: textureLod of arrays and cubes, a bias of arrays, gradients of arrays of cubes.
// RUN: not %clipc -T ps_6_8 -E missing %s -o - 2>&1 | FileCheck %s --check-prefix=MISSING
// RUN: not %clipc -T ps_6_8 -E raw %s -o - 2>&1 | FileCheck %s --check-prefix=RAW
// RUN: not %clipc -T ps_5_0 -E newer %s -o - 2>&1 | FileCheck %s --check-prefix=NEWER
// RUN: not %clipc -T vs_6_8 -E vertex %s -o - 2>&1 | FileCheck %s --check-prefix=VERTEX
Texture2D map;
Texture2DArray layers;
TextureCubeArray skies;
SamplerComparisonState compares;
float4 missing(float4 p : P) : SV_Target {
  float4 c = layers.SampleCmpLevel(compares, p.xyz, p.w, 1);
  c += layers.SampleCmpBias(compares, p.xyz, p.w, 1);
  return c + skies.SampleCmpGrad(compares, p, 0, p.xyz, p.xyz);
}
// MISSING: [[#@LINE-4]]:14: error: a texture is compared by this method; target `glsl450` has no function for that [target-sample-compare]
// MISSING: [[#@LINE-4]]:8: error: a texture is compared by this method
// MISSING: [[#@LINE-4]]:14: error: a texture is compared by this method

float4 raw(float4 p : P) : SV_Target { return map.GatherRaw(compares, p.xy); }
// RAW: error: `GatherRaw` of `Texture2D<float4>` is not supported by clipc [method-unsupported]

float4 newer(float4 p : P) : SV_Target { return map.SampleCmpLevel(compares, p.xy, p.z, 2); }
// NEWER: error: `SampleCmpLevel` needs profile ps_6_7 or later; this is `ps_5_0` [intrinsic-profile, X4532]

float4 vertex(float4 p : P) : SV_Position { return map.SampleCmpBias(compares, p.xy, p.z, 2); }
// VERTEX: error: `SampleCmpBias` needs the level of detail of neighbouring pixels; a vertex shader has none [method-implicit-level, X4532]
