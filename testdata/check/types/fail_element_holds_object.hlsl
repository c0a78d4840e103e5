// The elements of textures and buffers are numbers, also where nothing uses them: fxc X3124, "object element type cannot be an object
// type", in DXC's template-checks.hlsl.
// RUN: not %clipc -T ps_5_0 %s -o - 2>&1 | FileCheck %s
// RUN: not %clipc -T ps_6_0 %s -o - 2>&1 | FileCheck %s
struct Holds { Texture2D map; float4 a; };
struct Deep { float b; Holds c[2]; };
struct Samples { SamplerState s; };
struct Numbers { float4 a; };
// CHECK-DAG: [[#@LINE+1]]:18: error: `StructuredBuffer` has elements of type `Texture2D<float4>`, which is an object or holds one; elements are made of numbers alone [element-holds-object, X3124]
StructuredBuffer<Texture2D> maps;
// CHECK-DAG: [[#@LINE+1]]:20: error: `RWStructuredBuffer` has elements of type `Holds`, which is an object or holds one
RWStructuredBuffer<Holds> holds : register(u1);
// CHECK-DAG: [[#@LINE+1]]:24: error: `AppendStructuredBuffer` has elements of type `Deep`
AppendStructuredBuffer<Deep> deep : register(u2);
// CHECK-DAG: [[#@LINE+1]]:25: error: `ConsumeStructuredBuffer` has elements of type `Samples`
ConsumeStructuredBuffer<Samples> samples : register(u3);
// CHECK-DAG: [[#@LINE+1]]:18: error: `StructuredBuffer` has elements of type `StructuredBuffer<float4>`
StructuredBuffer<StructuredBuffer<float4> > nested;
// CHECK-DAG: [[#@LINE+1]]:18: error: `StructuredBuffer` has elements of type `Texture2D<float4>[2]`
StructuredBuffer<Texture2D[2]> arrays;
// CHECK-DAG: [[#@LINE+1]]:11: error: `Texture2D` has elements of type `SamplerState`
Texture2D<SamplerState> unused;
// CHECK-DAG: [[#@LINE+1]]:8: error: `Buffer` has elements of type `Holds`
Buffer<Holds> typed;
// CHECK-DAG: [[#@LINE+1]]:18: error: `StructuredBuffer` of `void`; `void` has no values [void-value, X3038]
StructuredBuffer<void> nothing;
StructuredBuffer<Numbers> right;
ByteAddressBuffer bytes;
float4 main(float4 p : P) : SV_Target {
  // CHECK-DAG: [[#@LINE+1]]:25: error: `Load` with the type argument `Holds` is not supported
  float4 loaded = bytes.Load<Holds>(0).a;
  return maps[0].Load(0) + holds[0].a + nested[0][1] + arrays[1][0].Load(0) + right[0].a + nothing[0];
}
