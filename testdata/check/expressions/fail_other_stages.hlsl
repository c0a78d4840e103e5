// What belongs to other shader stages, or to other targets, each with its reason (Direct3D functional spec; fxc says X4532).
// RUN: not %clipc -T vs_6_5 %s -o %t 2>&1 | FileCheck %s
// AUTOUPDATE
RWStructuredBuffer<uint> counters;
SamplerState linear_clamp;
Texture2D map;
sampler2D old_map;
uint shared_value;

float4 main(float4 p : POSITION) : SV_Position {
  uint before;
// CHECK: fail_other_stages.hlsl:[[#@LINE+3]]:39: error: `InterlockedCompareStoreFloatBitwise` changes an element of an unordered access view, `buffer[i]`, a member of one of a structured buffer, or a `groupshared` variable, that is a `float` [intrinsic-atomic-target, X3013]
// CHECK-NEXT:    [[#@LINE+2]] |   InterlockedCompareStoreFloatBitwise(counters[0], 1, 2);
// CHECK-NEXT:       |                                       ^~~~~~~~~~~
  InterlockedCompareStoreFloatBitwise(counters[0], 1, 2);
// CHECK-NEXT: fail_other_stages.hlsl:[[#@LINE+3]]:3: error: `GroupMemoryBarrierWithGroupSync` is a memory barrier; there is nothing to wait for in a vertex shader [intrinsic-barrier, X4532]
// CHECK-NEXT:    [[#@LINE+2]] |   GroupMemoryBarrierWithGroupSync();
// CHECK-NEXT:       |   ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
  GroupMemoryBarrierWithGroupSync();
// CHECK-NEXT: fail_other_stages.hlsl:[[#@LINE+3]]:3: warning: `printf` is ignored; no target of clipc prints debug messages [-Wintrinsic-debug]
// CHECK-NEXT:    [[#@LINE+2]] |   printf("here");
// CHECK-NEXT:       |   ^~~~~~
  printf("here");
// CHECK-NEXT: fail_other_stages.hlsl:[[#@LINE+3]]:3: error: `clip` discards a pixel; a vertex shader clips with `[clipplanes(...)]` or with SV_ClipDistance [intrinsic-discard, X4532]
// CHECK-NEXT:    [[#@LINE+2]] |   clip(p.x);
// CHECK-NEXT:       |   ^~~~
  clip(p.x);
// CHECK-NEXT: fail_other_stages.hlsl:[[#@LINE+3]]:12: error: `CalculateLevelOfDetail` needs the level of detail of neighbouring pixels; a vertex shader has none [method-implicit-level, X4532]
// CHECK-NEXT:    [[#@LINE+2]] |   p += map.CalculateLevelOfDetail(linear_clamp, p.xy);
// CHECK-NEXT:       |            ^~~~~~~~~~~~~~~~~~~~~~
  p += map.CalculateLevelOfDetail(linear_clamp, p.xy);
// CHECK-NEXT: fail_other_stages.hlsl:[[#@LINE+3]]:8: error: `tex2D` gets the level of detail from neighbouring pixels; a vertex shader gives it in the last component of `tex2Dlod` [intrinsic-implicit-level, X4532]
// CHECK-NEXT:    [[#@LINE+2]] |   p += tex2D(old_map, p.xy);
// CHECK-NEXT:       |        ^~~~~
  p += tex2D(old_map, p.xy);
// CHECK-NEXT: fail_other_stages.hlsl:[[#@LINE+3]]:8: error: `EvaluateAttributeAtSample` evaluates an interpolated input; a vertex shader's inputs are not interpolated [intrinsic-interpolation, X4532]
// CHECK-NEXT:    [[#@LINE+2]] |   p += EvaluateAttributeAtSample(p, 0);
// CHECK-NEXT:       |        ^~~~~~~~~~~~~~~~~~~~~~~~~
  p += EvaluateAttributeAtSample(p, 0);
// CHECK-NEXT: fail_other_stages.hlsl:[[#@LINE+3]]:3: error: `SetMeshOutputCounts` belongs to mesh and amplification shaders; a vertex shader cannot call it [intrinsic-mesh, X4532]
// CHECK-NEXT:    [[#@LINE+2]] |   SetMeshOutputCounts(1, 1);
// CHECK-NEXT:       |   ^~~~~~~~~~~~~~~~~~~
  SetMeshOutputCounts(1, 1);
// CHECK-NEXT: fail_other_stages.hlsl:[[#@LINE+3]]:8: error: `noise` exists only in texture shaders, which run on the CPU; read a noise texture instead [intrinsic-noise, X3004]
// CHECK-NEXT:    [[#@LINE+2]] |   p += noise(p.xyz);
// CHECK-NEXT:       |        ^~~~~
  p += noise(p.xyz);
// CHECK-NEXT: fail_other_stages.hlsl:[[#@LINE+3]]:18: error: `InterlockedAdd` changes an element of an unordered access view, `buffer[i]`, a member of one of a structured buffer, or a `groupshared` variable, that is an `int` or `uint` [intrinsic-atomic-target, X3013]
// CHECK-NEXT:    [[#@LINE+2]] |   InterlockedAdd(shared_value, 1);
// CHECK-NEXT:       |                  ^~~~~~~~~~~~
  InterlockedAdd(shared_value, 1);
// CHECK-NEXT: fail_other_stages.hlsl:[[#@LINE+3]]:3: error: `GetRemainingRecursionLevels` belongs to work graphs; a vertex shader cannot call it [intrinsic-work-graph, X4532]
// CHECK-NEXT:    [[#@LINE+2]] |   GetRemainingRecursionLevels();
// CHECK-NEXT:       |   ^~~~~~~~~~~~~~~~~~~~~~~~~~~
  GetRemainingRecursionLevels();
// CHECK-NEXT: fail_other_stages.hlsl:[[#@LINE+3]]:8: error: `DispatchRaysDimensions` belongs to ray tracing shaders; a vertex shader cannot call it [intrinsic-ray-tracing, X4532]
// CHECK-NEXT:    [[#@LINE+2]] |   p += DispatchRaysDimensions().x;
// CHECK-NEXT:       |        ^~~~~~~~~~~~~~~~~~~~~~
  p += DispatchRaysDimensions().x;
// CHECK-NEXT: fail_other_stages.hlsl:[[#@LINE+3]]:8: error: `GetRenderTargetSampleCount` asks about the pixel being drawn; a vertex shader has none [intrinsic-render-target, X4532]
// CHECK-NEXT:    [[#@LINE+2]] |   p += GetRenderTargetSampleCount();
// CHECK-NEXT:       |        ^~~~~~~~~~~~~~~~~~~~~~~~~~
  p += GetRenderTargetSampleCount();
  float2 edges;
// CHECK-NEXT: fail_other_stages.hlsl:[[#@LINE+3]]:3: error: `Process2DQuadTessFactorsAvg` computes tessellation factors; only a hull shader has them [intrinsic-tessellation, X4532]
// CHECK-NEXT:    [[#@LINE+2]] |   Process2DQuadTessFactorsAvg(p, p.xy, p, p.xy, edges);
// CHECK-NEXT:       |   ^~~~~~~~~~~~~~~~~~~~~~~~~~~
  Process2DQuadTessFactorsAvg(p, p.xy, p, p.xy, edges);
// CHECK-NEXT: fail_other_stages.hlsl:[[#@LINE+3]]:12: warning: `Sample` gets the level of detail from neighbouring pixels, which a vertex shader does not have; it reads level 0 here, fxc reports an error; call `SampleLevel` instead [-Wmethod-level-zero]
// CHECK-NEXT:    [[#@LINE+2]] |   p += map.Sample(linear_clamp, p.xy);
// CHECK-NEXT:       |            ^~~~~~
  p += map.Sample(linear_clamp, p.xy);
// CHECK-NEXT: fail_other_stages.hlsl:[[#@LINE+3]]:8: error: `ddx` is the difference between neighbouring pixels; a vertex shader has none [intrinsic-derivative, X4532]
// CHECK-NEXT:    [[#@LINE+2]] |   p += ddx(p);
// CHECK-NEXT:       |        ^~~
  p += ddx(p);
  return p;
}
