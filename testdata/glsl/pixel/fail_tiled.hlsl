// Reads with a clamp or a status that a target does not have.
// RUN: not %clipc %s -T ps_5_0 -E ps --target=glsl330 -o - 2>&1 | FileCheck %s
// RUN: not %clipc %s -T ps_5_0 -E line -o - 2>&1 | FileCheck %s --check-prefix=LINE
// RUN: not %clipc %s -T ps_5_0 -E memory -o - 2>&1 | FileCheck %s --check-prefix=MEMORY
// RUN: not %clipc %s -T ps_4_1 -E ps -o - 2>&1 | FileCheck %s --check-prefix=OLD
// RUN: not %clipc %s -T vs_5_0 -E vertex -o - 2>&1 | FileCheck %s --check-prefix=VERTEX
Texture2D map;
SamplerState smooth;

float4 ps(float2 uv : UV) : SV_Target {
  uint status;
  // OLD: [[#@LINE+4]]:20: error: `Sample` needs profile ps_5_0 or later; this is `ps_4_1` [intrinsic-profile, X4532]
  // CHECK: [[#@LINE+3]]:16: error: a texture is read with a clamp of the level of detail, as tiled resources are; target `glsl330` has no function for that [target-tiled]
  // CHECK: note: target `glsl450` can
  // CHECK-NOT: error
  float4 sum = map.Sample(smooth, uv, int2(0, 0), 0.5);
  // CHECK: [[#@LINE+1]]:10: error: a texture is read with a status, as tiled resources are; target `glsl330`
  sum += map.SampleLevel(smooth, uv, 0, int2(0, 0), status);
  // CHECK: [[#@LINE+1]]:10: error: a texture is read with a status
  return CheckAccessFullyMapped(status) ? sum : 0;
}

Texture1D ramp;
float4 line(float2 uv : UV) : SV_Target {
  uint status;
  // LINE: [[#@LINE+1]]:10: error: a texture is read with a status, as tiled resources are; target `glsl450` has no function for that [target-tiled]
  return ramp.Sample(smooth, uv.x, 0, 0.5, status) * status;
}

Buffer<float4> list;
StructuredBuffer<float4> items;
ByteAddressBuffer bytes;
float4 memory(float2 uv : UV) : SV_Target {
  uint status;
  // MEMORY: [[#@LINE+1]]:21: error: `Load` has a status of tiled resources; no target has one for a buffer [method-status]
  float4 sum = list.Load(1, status);
  // MEMORY: [[#@LINE+1]]:16: error: `Load` has a status of tiled resources; no target has one for a buffer
  sum += items.Load(1, status);
  // MEMORY: [[#@LINE+1]]:16: error: `Load2` has a status of tiled resources; no target has one for a buffer
  sum += bytes.Load2(8, status).xyxy;
  // MEMORY: [[#@LINE+1]]:14: error: `Load` takes 1 or 2 arguments; 3 given
  sum += map.Load(0, int2(0, 0), status + 1);
  return sum;
}

float4 vertex(float2 uv : UV) : SV_Position {
  uint status;
  // VERTEX: [[#@LINE+1]]:14: error: `Sample` needs the level of detail of neighbouring pixels; a vertex shader has none [method-implicit-level, X4532]
  return map.Sample(smooth, uv, int2(0, 0), 0.5, status);
}
