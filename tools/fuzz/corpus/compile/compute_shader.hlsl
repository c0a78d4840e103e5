//91
StructuredBuffer<float> values : register(t0);
RWStructuredBuffer<float> sums : register(u0);
RWTexture2D<float4> image;
struct Pair { float2 both; bool is_set; };
groupshared Pair pairs[8][8];
groupshared uint count;
static const uint kSize = 8;
[numthreads(kSize, 8, 1)]
void main(uint3 id : SV_DispatchThreadID, uint2 place : SV_GroupThreadID, uint3 group : SV_GroupID, uint i : SV_GroupIndex) {
  if (i == 0) count = 0;
  pairs[place.y][place.x].both = float2(values[i], id.z);
  pairs[place.y][place.x].is_set = values[i] > 0;
  GroupMemoryBarrierWithGroupSync();
  if (pairs[place.x][place.y].is_set) InterlockedAdd(count, 1u);
  AllMemoryBarrierWithGroupSync();
  sums[group.x * 64 + i] = pairs[7 - place.y][place.x].both.x * count;
  image[id.xy] = float4(pairs[place.y][0].both, 0, 1);
}
