// A sampler filters and compares floats; before shader model 6.7 it reads no integers at all: DXC's uintSample.hlsl and
// sampleInteger.hlsl. A gather reads integers in every model (its texture.gather-red.hlsl).
// RUN: not %clipc -T ps_5_0 %s -o - 2>&1 | FileCheck %s
// RUN: not %clipc -T ps_6_6 %s -o - 2>&1 | FileCheck %s
// RUN: not %clipc -T ps_6_7 -DNO_FILTERS %s -o - 2>&1 | FileCheck %s --check-prefix=COMPARES
// RUN: %clipc -T ps_6_7 -E filters --validate %s -o - | FileCheck %s --check-prefix=NEWER
// RUN: %clipc -T ps_5_0 -E gathers --validate %s -o - | FileCheck %s --check-prefix=GATHERS
Texture2D<uint> map;
Texture2D<int4> wide;
TextureCube<bool> sky;
SamplerState s;
SamplerComparisonState c;
float4 filters(float2 uv : UV) : SV_Target {
  // CHECK: [[#@LINE+3]]:18: error: `Sample` is called on a `Texture2D<uint>`; before shader model 6.7 a sampler filters floats only; `Load` reads integers [method-of-integers]
  // CHECK: [[#@LINE+2]]:39: error: `SampleBias` is called on a `Texture2D<int4>`
  // NEWER: texture(map, vs_UV0)
  float4 r = map.Sample(s, uv) + wide.SampleBias(s, uv, 1);
  // CHECK: [[#@LINE+2]]:13: error: `SampleLevel` is called on a `Texture2D<int4>`
  // CHECK: [[#@LINE+1]]:42: error: `SampleGrad` is called on a `Texture2D<int4>`
  r += wide.SampleLevel(s, uv, 0) + wide.SampleGrad(s, uv, uv, uv);
  return r;
}
float4 main(float2 uv : UV) : SV_Target {
  float4 r = map.Load(0) + wide.Gather(s, uv);
#ifndef NO_FILTERS
  r += filters(uv);
  // CHECK: [[#@LINE+1]]:12: error: `Sample` is called on a `TextureCube<bool>`
  r += sky.Sample(s, uv.xyx);
#endif
  // COMPARES: [[#@LINE+1]]:12: error: `SampleCmp` is called on a `Texture2D<uint>`; a sampler compares floats only; `Load` reads integers [method-of-integers]
  r += map.SampleCmp(c, uv, 0.5);
  return r;
}
// GATHERS: textureGather(map, vs_UV0)
uint4 gathers(float2 uv : UV) : SV_Target { return map.Gather(s, uv); }
