// An object that a condition chooses while the shader runs, which neither Direct3D up to 11 nor GLSL has. Source: dxc's test
// const_global.hlsl.
// RUN: not %clipc %s -T ps_6_0 -E ps -o - 2>&1 | FileCheck %s
Texture2D first : register(t0);
SamplerState near : register(s0);
SamplerState far : register(s1);
bool varies;

float4 ps(float2 uv : UV) : SV_Target {
  // CHECK: [[#@LINE+1]]:23: error: `?:` of type `SamplerState` is not one particular global; an object cannot be chosen at run time [object-not-global, X3031]
  return first.Sample(varies ? near : far, uv);
}
