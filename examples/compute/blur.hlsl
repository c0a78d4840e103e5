// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A blur in tiles: a group loads each texel once, and all of its threads read it.
// clipc -T cs_5_0
static const uint kRadius = 2;
static const uint kTile = 8;                    // texels that a group writes, along x and y
static const uint kSide = kTile + 2 * kRadius;  // texels that it reads
static const float kWeights[2 * kRadius + 1] = {0.0625, 0.25, 0.375, 0.25, 0.0625};

Texture2D<float4> source : register(t0);
RWTexture2D<float4> blurred : register(u0);

groupshared float4 texels[kSide][kSide];
groupshared float4 rows[kSide][kTile];  // blurred along x

[numthreads(kTile, kTile, 1)]
void main(uint2 id : SV_DispatchThreadID, uint2 group : SV_GroupID, uint2 thread : SV_GroupThreadID,
          uint index : SV_GroupIndex) {
  // The tile and its border have 144 texels, and the group has 64 threads: each loads two or three.
  // The border repeats the texels at the edge of the image.
  uint2 size;
  source.GetDimensions(size.x, size.y);
  const int2 corner = int2(group * kTile) - int(kRadius);
  for (uint i = index; i < kSide * kSide; i += kTile * kTile) {
    const uint2 at = uint2(i % kSide, i / kSide);
    texels[at.y][at.x] = source[clamp(corner + int2(at), 0, int2(size) - 1)];
  }
  // Below this barrier, a thread reads what other threads have loaded.
  GroupMemoryBarrierWithGroupSync();

  // Along x, for the rows of the border too: the columns need them.
  for (uint j = index; j < kSide * kTile; j += kTile * kTile) {
    const uint2 at = uint2(j % kTile, j / kTile);
    float4 sum = 0;
    for (uint k = 0; k <= 2 * kRadius; ++k) sum += kWeights[k] * texels[at.y][at.x + k];
    rows[at.y][at.x] = sum;
  }
  GroupMemoryBarrierWithGroupSync();

  // Along y: 5 + 5 products for most texels, where a square of weights needs 25.
  float4 sum = 0;
  for (uint k = 0; k <= 2 * kRadius; ++k) sum += kWeights[k] * rows[thread.y + k][thread.x];
  // A group at the edge has threads outside of the image. They come to both barriers like the
  // others, and only store nothing.
  if (all(id < size)) blurred[id] = sum;
}
