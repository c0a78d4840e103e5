// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A histogram of brightness: a group counts in its own memory, and then adds that to the buffer.
// clipc -T cs_5_0
static const uint kSide = 8;
static const uint kBins = kSide * kSide;  // one for each thread of a group

Texture2D<float4> image : register(t0);
RWStructuredBuffer<uint> histogram : register(u0);  // kBins numbers, 0 before the dispatch

groupshared uint bins[kBins];

uint BinOf(float3 color) {
  const float brightness = dot(color, float3(0.2126, 0.7152, 0.0722));
  return min(uint(saturate(brightness) * kBins), kBins - 1);
}

[numthreads(kSide, kSide, 1)]
void main(uint2 id : SV_DispatchThreadID, uint index : SV_GroupIndex) {
  // The memory of a group has no values at first.
  bins[index] = 0;
  GroupMemoryBarrierWithGroupSync();

  // Several threads may add to one bin at the same time, so the addition is atomic.
  uint2 size;
  image.GetDimensions(size.x, size.y);
  if (all(id < size)) InterlockedAdd(bins[BinOf(image[id].rgb)], 1);
  GroupMemoryBarrierWithGroupSync();

  // Several groups may add to the buffer at the same time: one atomic addition for each bin with
  // texels in it, where a count without the bins would need one for each texel.
  if (bins[index] != 0) InterlockedAdd(histogram[index], bins[index]);
}
