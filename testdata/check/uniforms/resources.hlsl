// RUN: %clipc -T vs_5_0 -E main --dump=ir %s | FileCheck %s
// CHECK: resource Texture2D<float4> heights : t3 explicit
Texture2D heights : register(t3);
// CHECK-NEXT: resource SamplerState linear_sampler : s1 explicit
SamplerState linear_sampler : register(s1) { Filter = MIN_MAG_MIP_LINEAR; };
// CHECK-NEXT: resource Buffer<uint2> typed : t0
Buffer<uint2> typed;
struct Item { float4 x; };
// CHECK-NEXT: resource StructuredBuffer<Item> items : t4 explicit
StructuredBuffer<Item> items : register(ps_5_0, t9) : register(vs_5_0, t4);
ByteAddressBuffer bytes;
RWTexture2D<float> never_used;
float4 through(Texture2D t, SamplerState s, float2 at) { return t.SampleLevel(s, at, 0); }
float4 main(float4 v : POSITION, uint id : SV_VertexID) : SV_Position {
  // A local object, and a parameter, is another name of the global one.
  Texture2D same = heights;
  // CHECK: v += through(v.xy)
  v += through(same, linear_sampler, v.xy);
  // CHECK: v += structured_load(items, {{.*}}id).x
  v += items[id].x;
  // CHECK: v.xy += convert<float2>(buffer_load(typed,
  v.xy += typed[id];
  // CHECK: v.xyz += asfloat(byte_load(bytes, id * 12u))
  v.xyz += bytes.Load<float3>(id * 12);
  return v;
}
