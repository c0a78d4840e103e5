// Tiled resources: the clamp and the status of a sample, which Direct3D 11.2 has after its offset.
// RUN: not %clipc %s -T ps_5_0 -E ps -o - 2>&1 | FileCheck %s
Texture2D map;
TextureCube sky;
SamplerState smooth;

float4 ps(float2 uv : UV) : SV_Target {
  uint status;
  // CHECK: [[#@LINE+1]]:20: error: `Sample` with a clamp of the level of detail, or with a status after one, is for tiled resources; no target of clipc has them [method-clamp]
  float4 sum = map.Sample(smooth, uv, int2(0, 0), 0.5);
  // CHECK: [[#@LINE+1]]:14: error: `Sample` with a clamp
  sum += map.Sample(smooth, uv, int2(0, 0), 0.5, status);
  // CHECK: [[#@LINE+1]]:14: error: `Sample` with a clamp
  sum += sky.Sample(smooth, uv.xyx, 0.5);
  // CHECK: [[#@LINE+1]]:14: error: `SampleLevel` with a status asks about tiled resources; no target of clipc has them [method-status, X4532]
  sum += map.SampleLevel(smooth, uv, 0, int2(0, 0), status);
  // CHECK: [[#@LINE+1]]:10: error: `CheckAccessFullyMapped` asks about tiled resources; no target of clipc has them [intrinsic-tiled, X4532]
  return CheckAccessFullyMapped(status) ? sum : 0;
}
