// RUN: not %clipc %s -T ps_5_0 -E ps --target=glsl450 -o - 2>&1 | FileCheck %s
// RUN: not %clipc %s -T ps_5_0 -E counts --target=glsl330 -o - 2>&1 | FileCheck %s --check-prefix=OLD
AppendStructuredBuffer<float4> added : register(u1);
ConsumeStructuredBuffer<float4> taken : register(u2);
RWStructuredBuffer<uint> counted : register(u3);
RWByteAddressBuffer bytes : register(u4);

float4 ps(float4 color : COLOR) : SV_Target {
  // CHECK: [[#@LINE+1]]:9: error: `AppendStructuredBuffer<float4>` has no method `Consume` [method-unknown, X3018]
  added.Consume();
  // CHECK: [[#@LINE+1]]:9: error: `AppendStructuredBuffer<float4>` has no method `IncrementCounter` [method-unknown, X3018]
  added.IncrementCounter();
  // CHECK: [[#@LINE+1]]:9: error: `ConsumeStructuredBuffer<float4>` has no method `Append` [method-unknown, X3018]
  taken.Append(color);
  // CHECK: [[#@LINE+1]]:9: error: `ConsumeStructuredBuffer<float4>` has no method `Load` [method-unknown, X3018]
  taken.Load(0);
  // CHECK: [[#@LINE+1]]:3: error: `AppendStructuredBuffer<float4>` has no elements or texels to index [object-not-indexed, X3121]
  added[0] = color;
  // CHECK: [[#@LINE+1]]:9: error: `RWByteAddressBuffer` has no method `IncrementCounter` [method-unknown, X3018]
  bytes.IncrementCounter();
  // CHECK: [[#@LINE+1]]:9: error: `Append` takes 1 argument; 2 given [intrinsic-argument-count, X3013]
  added.Append(color, color);
  return color;
}

// One target's lack of buffers is said once of a buffer and its counter.
// OLD: error: `counted` is a buffer of any layout; target `glsl330` has no storage buffers [target-storage-buffer]
// OLD: note: target `glsl430` can
// OLD-NOT: error
float4 counts() : SV_Target { return counted[counted.IncrementCounter()]; }
