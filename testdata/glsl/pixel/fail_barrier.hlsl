// Where there is no barrier.
// RUN: not %clipc %s -T ps_5_0 -E plain --target=glsl330 -o - 2>&1 | FileCheck %s --check-prefix=OLD
// RUN: not %clipc %s -T vs_5_0 -E vertex -o - 2>&1 | FileCheck %s --check-prefix=VERTEX
// OLD: [[#@LINE+2]]:3: error: `DeviceMemoryBarrier` orders what invocations store; target `glsl330` has no function for that [target-barrier]
float4 plain() : SV_Target {
  DeviceMemoryBarrier();
  return 0;
}

// VERTEX: [[#@LINE+2]]:3: error: `DeviceMemoryBarrier` is a memory barrier; there is nothing to wait for in a vertex shader [intrinsic-barrier, X4532]
float4 vertex() : SV_Position {
  DeviceMemoryBarrier();
  return 0;
}
