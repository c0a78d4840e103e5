// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/clip_status.h"

namespace clipc::runtime {
namespace {

// The number of vertices in a block: enough for full vectors of any width, small enough to stay in
// registers and the first-level cache.
constexpr std::size_t kVerticesOfBlock = 32;

// The vertices of a block, component by component, and their codes so far.
struct VertexBlock {
  float x[kVerticesOfBlock], y[kVerticesOfBlock], z[kVerticesOfBlock], w[kVerticesOfBlock];
  std::uint32_t code[kVerticesOfBlock];
};

// Returns `bit` unless `inside`. NaN, for which every comparison is false, is outside.
std::uint32_t Unless(bool inside, std::uint32_t bit) { return inside ? 0 : bit; }

std::uint32_t FrustumCode(float x, float y, float z, float w) {
  return Unless(x >= -w, kClipLeft) | Unless(x <= w, kClipRight) | Unless(y <= w, kClipTop) |
         Unless(y >= -w, kClipBottom) | Unless(z >= 0, kClipFront) | Unless(z <= w, kClipBack);
}

std::uint32_t PlaneCode(const float (&plane)[4], float x, float y, float z, float w,
                        std::uint32_t bit) {
  return Unless(plane[0] * x + plane[1] * y + plane[2] * z + plane[3] * w >= 0, bit);
}

void CodeBlock(VertexBlock& block, const UserClipPlanes& user_planes) {
  for (std::size_t i = 0; i < kVerticesOfBlock; ++i)
    block.code[i] = FrustumCode(block.x[i], block.y[i], block.z[i], block.w[i]);
  for (std::uint32_t plane = 0; plane < 6; ++plane) {
    if ((user_planes.enable_mask >> plane & 1) == 0) continue;
    const std::uint32_t bit = std::uint32_t{kClipPlane0} << plane;
    for (std::size_t i = 0; i < kVerticesOfBlock; ++i) {
      block.code[i] |=
          PlaneCode(user_planes.planes[plane], block.x[i], block.y[i], block.z[i], block.w[i], bit);
    }
  }
}

}  // namespace

std::uint32_t ClipCode(const float (&position)[4], const UserClipPlanes& user_planes) noexcept {
  const float x = position[0], y = position[1], z = position[2], w = position[3];
  std::uint32_t code = FrustumCode(x, y, z, w);
  for (std::uint32_t plane = 0; plane < 6; ++plane) {
    if ((user_planes.enable_mask >> plane & 1) == 0) continue;
    code |= PlaneCode(user_planes.planes[plane], x, y, z, w, std::uint32_t{kClipPlane0} << plane);
  }
  return code;
}

void UpdateClipStatus(ClipStatus& status, const float* positions, std::size_t count,
                      const UserClipPlanes& user_planes, bool clipping,
                      std::uint16_t* codes) noexcept {
  if (!clipping) {
    status = {0, 0};
    for (std::size_t i = 0; codes != nullptr && i < count; ++i) codes[i] = 0;
    return;
  }
  VertexBlock block;
  std::size_t first = 0;
  for (; count - first >= kVerticesOfBlock; first += kVerticesOfBlock) {
    const float* from = positions + 4 * first;
    for (std::size_t i = 0; i < kVerticesOfBlock; ++i) {
      block.x[i] = from[4 * i], block.y[i] = from[4 * i + 1], block.z[i] = from[4 * i + 2],
      block.w[i] = from[4 * i + 3];
    }
    CodeBlock(block, user_planes);
    std::uint32_t any = 0, all = 0xFFFFFFFFu;
    for (std::size_t i = 0; i < kVerticesOfBlock; ++i) any |= block.code[i], all &= block.code[i];
    status.clip_union |= any;
    status.clip_intersection &= all;
    if (codes == nullptr) continue;
    for (std::size_t i = 0; i < kVerticesOfBlock; ++i)
      codes[first + i] = static_cast<std::uint16_t>(block.code[i]);
  }
  for (; first < count; ++first) {
    const float* from = positions + 4 * first;
    const std::uint32_t code = ClipCode({from[0], from[1], from[2], from[3]}, user_planes);
    status.clip_union |= code;
    status.clip_intersection &= code;
    if (codes != nullptr) codes[first] = static_cast<std::uint16_t>(code);
  }
}

}  // namespace clipc::runtime
