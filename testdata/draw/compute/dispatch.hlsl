// A dispatch: what a compute shader stores in buffers and images, through memory that its groups share, on Mesa and in the
// reference evaluator, which runs a group from one barrier to the next.
// RUN: %draw compare %s -T cs_5_0 -E reduce
// RUN: %draw compare %s -T cs_5_0 -E scan
// RUN: %draw compare %s -T cs_5_0 -E histogram
// RUN: %draw compare %s -T cs_5_0 -E blur
// RUN: %draw compare %s -T cs_4_0 -E old --target=glsl430,essl310,vulkan
// RUN: %draw compare %s -T cs_5_0 -E types
// RUN: %draw compare %s -T cs_6_0 -E numbers
cbuffer Frame { float4x4 turn; float4 weights; uint shift; };
StructuredBuffer<float> values;
RWStructuredBuffer<float> sums;
RWStructuredBuffer<uint> counts;
RWByteAddressBuffer raw;
RWTexture2D<float4> image;
Texture2D<float4> picture;

groupshared float parts[32];
// Sums by halves.
[numthreads(32, 1, 1)]
void reduce(uint i : SV_GroupIndex, uint3 group : SV_GroupID, uint3 id : SV_DispatchThreadID) {
  parts[i] = values[id.x];
  GroupMemoryBarrierWithGroupSync();
  for (uint s = 16; s > 0; s >>= 1) {
    if (i < s) parts[i] += parts[i + s];
    GroupMemoryBarrierWithGroupSync();
  }
  if (i == 0) sums[group.x + 3 * group.y] = parts[0];
}

groupshared float2 row[2][32];
// Sums of all values up to each, between two rows.
[numthreads(32, 1, 1)]
void scan(uint i : SV_GroupThreadID, uint2 group : SV_GroupID) {
  uint from = 0;
  row[0][i] = float2(values[i + 32 * group.x], i);
  for (uint step = 1; step < 32; step *= 2) {
    GroupMemoryBarrierWithGroupSync();
    row[1 - from][i] = row[from][i] + (i >= step ? row[from][i - step] : 0);
    from = 1 - from;
  }
  if (group.y == 0) sums[i + 32 * group.x] = row[from][i].x + row[from][i].y;
}

groupshared uint bins[16];
groupshared int lowest;
// Atomic operations whose order does not matter.
[numthreads(8, 8, 1)]
void histogram(uint i : SV_GroupIndex, uint2 id : SV_DispatchThreadID) {
  if (i < 16) bins[i] = i;
  if (i == 0) lowest = 1000;
  AllMemoryBarrierWithGroupSync();
  const uint bin = (id.x * 7 + id.y * 3) & 15;
  InterlockedAdd(bins[bin], 1 + (id.y & 1));
  InterlockedMin(lowest, (int)id.x - (int)id.y);
  InterlockedOr(bins[15], 1u << (i & 31));
  GroupMemoryBarrierWithGroupSync();
  if (i < 16) InterlockedAdd(counts[i], bins[i]);
  if (i == 16) InterlockedMin(counts[16], lowest + 100);
  if (i < 16) raw.InterlockedMax(4 * i, bins[i] + i);
  raw.Store2(256 + 8 * (id.x + 24 * id.y), uint2(id.x, i));
}

groupshared float4 tile[10][10];
[numthreads(8, 8, 1)]
void blur(uint2 at : SV_GroupThreadID, uint2 id : SV_DispatchThreadID, uint i : SV_GroupIndex) {
  tile[at.y + 1][at.x + 1] = picture.Load(int3(id % 4, 0));
  if (i < 10) tile[0][i] = tile[9][i] = 0;
  if (i < 8) tile[i + 1][0] = tile[i + 1][9] = 1;
  GroupMemoryBarrierWithGroupSync();
  float4 sum = 0;
  for (uint y = 0; y < 3; ++y)
    for (uint x = 0; x < 3; ++x) sum += tile[at.y + y][at.x + x] * weights[y];
  image[id] = sum;
}

// No images and no atomic operations; one layer.
[numthreads(16, 2, 1)]
void old(uint i : SV_GroupIndex, uint3 id : SV_DispatchThreadID) {
  parts[i] = values[i] * weights.x;
  GroupMemoryBarrierWithGroupSync();
  sums[id.x + 48 * id.y] = parts[31 - i];
}

struct Item { float3 color; bool is_set; float2x3 basis; int2 place; };
groupshared Item items[4];
groupshared float4x4 turns[2];
groupshared bool flags[3];
groupshared min16float small;
// Structs, matrices, bools and vectors by components.
[numthreads(4, 1, 1)]
void types(uint i : SV_GroupIndex, uint3 id : SV_DispatchThreadID) {
  items[i].color.zx = float2(i, values[i]);
  items[i].color.y = weights[i];
  items[i].is_set = (i & 1) != 0;
  items[i].basis[1] = weights.xyz;
  items[i].basis._m00_m01_m02 = i;
  items[i].place = int2(-1, i);
  if (i == 0) {
    turns[0] = turn;
    turns[1] = 2;
    small = 3;
  }
  if (i < 3) flags[i] = i == shift % 3;
  GroupMemoryBarrierWithGroupSync();
  const Item other = items[3 - i];
  float4 sum = mul(turns[i & 1], float4(other.color, other.is_set ? 1 : 2));
  sum.xyz += mul(float2(1, 2), other.basis) + small;
  sum.w += flags[i % 3] ? other.place.y : other.place.x;
  const uint first = 4 * (id.x + 12 * id.y);
  for (uint k = 0; k < 4; ++k) sums[first + k] = sum[k];
}

// Every number of a thread.
[numthreads(3, 2, 2)]
void numbers(int3 id : SV_DispatchThreadID, uint3 group : SV_GroupID, uint2 at : SV_GroupThreadID, int i : SV_GroupIndex) {
  const uint first = 8 * (id.x + 9 * (id.y + 4 * id.z));
  if (id.z == 1 && id.y > 1) return;
  raw.Store4(4 * first, uint4(id, i));
  raw.Store3(4 * first + 16, uint3(group.xy, at.x * 16 + at.y));
}
