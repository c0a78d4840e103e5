// Types and methods that a profile does not have. Oracle: "Minimum Shader Model" of their pages in Microsoft's HLSL reference, and of the
// instructions (gather4, lod: sm4.1; gather4_c: sm5), which vkd3d's gather, gather-cmp and calculate-lod.shader_test require too. StructuredBuffer and ByteAddressBuffer are "available for compute and pixel shaders
// in Direct3D 11 on some Direct3D 10 devices" in model 4.
// RUN: not %clipc -T ps_3_0 -E objects -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=P30
// RUN: not %clipc -T ps_4_0 -E objects -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=P40
// RUN: not %clipc -T ps_4_1 -E objects -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=P41
// RUN: %clipc -T ps_5_0 -E objects -fsyntax-only %s 2>&1 | count 0
// RUN: not %clipc -T ps_3_0 -E methods -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=M30
// RUN: not %clipc -T ps_4_0 -E methods -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=M40
// RUN: not %clipc -T ps_4_1 -E methods -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=M41
// RUN: %clipc -T ps_5_0 -E methods -fsyntax-only %s 2>&1 | count 0
// RUN: not %clipc -T ps_4_0 -E numbers -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=N40
// RUN: %clipc -T ps_5_0 -E numbers -fsyntax-only %s 2>&1 | count 0
// RUN: %clipc -T ps_3_0 -E samples -fsyntax-only %s 2>&1 | count 0
// RUN: %clipc -T ps_4_0 -E unused -fsyntax-only %s 2>&1 | count 0
SamplerState s;
SamplerComparisonState c;
Texture2D<float4> map;
// P30-NOT: error
// P30: [[#@LINE+3]]:23: error: `TextureCubeArray<float4>` needs profile ps_4_1 or later; this is `ps_3_0` [type-profile, X3653]
// P40-NOT: error
// P40: [[#@LINE+1]]:23: error: `TextureCubeArray<float4>` needs profile ps_4_1 or later; this is `ps_4_0` [type-profile, X3653]
TextureCubeArray      cubes;
// P30: [[#@LINE+1]]:24: error: `Texture2DArray<float4>` needs profile ps_4_0 or later; this is `ps_3_0`
Texture2DArray<float4> layers[2];
// P30: [[#@LINE+1]]:23: error: `Buffer<float4>` needs profile ps_4_0
Buffer<float4>        typed;
// P30: [[#@LINE+1]]:26: error: `StructuredBuffer<float4>` needs profile ps_4_0
StructuredBuffer<float4> list;
// P30: [[#@LINE+1]]:23: error: `ByteAddressBuffer` needs profile ps_4_0
ByteAddressBuffer     bytes;
// P30: [[#@LINE+5]]:29: error: `RWStructuredBuffer<float4>` needs profile ps_5_0
// P40-NOT: error
// P40: [[#@LINE+3]]:29: error: `RWStructuredBuffer<float4>` needs profile ps_5_0 or later; this is `ps_4_0`
// P41-NOT: error
// P41: [[#@LINE+1]]:29: error: `RWStructuredBuffer<float4>` needs profile ps_5_0 or later; this is `ps_4_1`
RWStructuredBuffer<float4>  written : register(u3);
// P40: [[#@LINE+2]]:21: error: `RWTexture2D<float>` needs profile ps_5_0
// P41: [[#@LINE+1]]:21: error: `RWTexture2D<float>` needs profile ps_5_0
RWTexture2D<float>  image : register(u4);

float4 objects(float3 p : P) : SV_Target {
  written[0] = 1;
  image[uint2(0, 0)] = 1;
  return cubes.Sample(s, float4(p, 0)) + layers[0].Sample(s, p) + typed.Load(0) + list[1] + asfloat(bytes.Load(0));
}
float4 methods(float3 p : P) : SV_Target {
  float4 r = map.Sample(s, p.xy);
  // M30: [[#@LINE+1]]:12: error: `Load` needs profile ps_4_0 or later; this is `ps_3_0` [intrinsic-profile, X4532]
  r += map.Load(int3(0, 0, 0));
  // M30: [[#@LINE+1]]:8: error: `[]` needs profile ps_4_0
  r += map[uint2(1, 1)];
  // M30: [[#@LINE+3]]:12: error: `Gather` needs profile ps_4_1
  // M40-NOT: error
  // M40: [[#@LINE+1]]:12: error: `Gather` needs profile ps_4_1 or later; this is `ps_4_0` [intrinsic-profile, X4532]
  r += map.Gather(s, p.xy);
  // M40: [[#@LINE+1]]:12: error: `GatherRed` needs profile ps_4_1
  r += map.GatherRed(s, p.xy, int2(1, 0));
  // M40: [[#@LINE+3]]:12: error: `GatherGreen` needs profile ps_5_0
  // M41-NOT: error
  // M41: [[#@LINE+1]]:12: error: `GatherGreen` needs profile ps_5_0 or later; this is `ps_4_1`
  r += map.GatherGreen(s, p.xy);
  // M41: [[#@LINE+1]]:12: error: `GatherCmp` needs profile ps_5_0
  r += map.GatherCmp(c, p.xy, p.z);
  // M30: [[#@LINE+2]]:12: error: `CalculateLevelOfDetail` needs profile ps_4_1
  // M40: [[#@LINE+1]]:12: error: `CalculateLevelOfDetail` needs profile ps_4_1
  r += map.CalculateLevelOfDetail(s, p.xy);
  // M30: [[#@LINE+1]]:12: error: `SampleCmp` needs profile ps_4_0
  r += map.SampleCmp(c, p.xy, p.z);
  uint w, h;
  // M30: [[#@LINE+1]]:7: error: `GetDimensions` needs profile ps_4_0
  map.GetDimensions(w, h);
  return r + w;
}
float4 numbers(nointerpolation uint n : N) : SV_Target {
  float4 r = countbits(n) + firstbithigh(n) + f16tof32(n);  // from 4.0 on: testdata/draw/pixel/halves_4_0.hlsl
  // N40: [[#@LINE+1]]:3: error: `double` needs profile ps_5_0 or later; this is `ps_4_0` [type-profile, X3653]
  double d = r.x;
  return r + (float)d;
}
// fxc makes Direct3D 9's samplers of these.
float4 samples(float3 p : TEXCOORD) : COLOR { return map.Sample(s, p.xy) + map.SampleBias(s, p.xy, 1) + map.SampleLevel(s, p.xy, 1); }
float4 unused() : SV_Target { return 1; }
