// GLSL's functions that read a texture, and methods that are nearly right.
// RUN: not %clipc -T ps_5_0 %s -fsyntax-only 2>&1 | FileCheck %s
Texture2D map;
SamplerState s;
float4 main(float2 uv : UV) : SV_Target {
  // CHECK: [[#@LINE+1]]:14: error: there is no function `texture`; in HLSL it is `map.Sample(sampler, uv)`, for Direct3D 9 `tex2D(sampler, uv)` [unknown-function, X3004]
  float4 a = texture(map, uv);
  // CHECK: [[#@LINE+1]]:8: error: there is no function `texture2D`; in HLSL it is `map.Sample(sampler, uv)`
  a += texture2D(map, uv);
  // CHECK: [[#@LINE+3]]:8: error: there is no function `textureLod`; in HLSL it is `map.SampleLevel(sampler, uv, level)` [unknown-function, X3004]
  // CHECK-NEXT: a += textureLod
  // CHECK-NEXT: ^~~~~~~~~~{{$}}
  a += textureLod(map, uv, 0);
  // CHECK: [[#@LINE+1]]:8: error: there is no function `texelFetch`; in HLSL it is `map.Load(int3(place, level))`
  a += texelFetch(map, int2(uv), 0);
  // CHECK: [[#@LINE+1]]:12: error: `Texture2D<float4>` has no method `SampleLvel`; did you mean `SampleLevel`? [method-unknown, X3018]
  a += map.SampleLvel(s, uv, 0);
  // CHECK: [[#@LINE+1]]:14: error: `Texture2D<float4>` has no method `Fetch` [method-unknown, X3018]
  return map.Fetch(uv);
}
