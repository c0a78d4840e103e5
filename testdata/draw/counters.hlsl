// A counter gives each vertex, and each pixel, an element of its own. Nothing says which is first: the outputs do not depend on that.
// RUN: %draw compare %s -T vs_5_0 --target=glsl450,vulkan
// RUN: %draw compare %s -T vs_5_0 --target=essl310 --lower=none
// RUN: %draw compare %s -T ps_5_0 -E ps --target=glsl430,essl310,vulkan
AppendStructuredBuffer<float4> added : register(u1);
ConsumeStructuredBuffer<float3> taken : register(u2);
RWStructuredBuffer<uint2> up : register(u3);
RWStructuredBuffer<int> down : register(u4);
ConsumeStructuredBuffer<float3> alone : register(u5);

uint4 Count(uint id, float4 p) {
  const uint i = up.IncrementCounter();
  up[i] = uint2(id, i);
  const uint j = down.DecrementCounter();
  down[j] = -int(id);
  if (id % 2 == 0) added.Append(p);
  const float3 last = taken.Consume();
  return uint4(all(up[i] == uint2(id, i)), down[j] == -int(id), i >= 96, j < 96);
}

struct Output {
  float4 position : SV_Position;
  nointerpolation uint4 counts : COUNTS;
  float3 last : LAST;
};

Output main(float4 p : POSITION, uint id : SV_VertexID) {
  Output o;
  o.position = p;
  o.counts = Count(id, p);
  o.last = 0;
  // What one vertex alone takes is the last element, and then the one before it.
  if (id == 3) o.last = alone.Consume() - 2 * alone.Consume();
  return o;
}

float4 ps(float4 p : PLACE, nointerpolation uint id : ID) : SV_Target { return Count(id, p); }
