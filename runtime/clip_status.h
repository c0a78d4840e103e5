// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>

/// Direct3D 9's clip status (D3DCLIPSTATUS9), computed on the CPU: the clip code of a vertex has a
/// bit for each plane that the vertex is outside of, and the status of a draw is the union and the
/// intersection of the codes. Pure functions: any thread, no allocation.
namespace clipc::runtime {

/// The bits of a clip code, with the values of d3d9types.h. Each is set unless the position (x, y,
/// z, w) in Direct3D clip space fulfils its inequality. The bit of user plane i, from 0 to 5, is
/// kClipPlane0 << i.
enum ClipCodeBit : std::uint32_t {
  kClipLeft = 0x001,    ///< D3DCS_LEFT: x >= -w
  kClipRight = 0x002,   ///< D3DCS_RIGHT: x <= w
  kClipTop = 0x004,     ///< D3DCS_TOP: y <= w
  kClipBottom = 0x008,  ///< D3DCS_BOTTOM: y >= -w
  kClipFront = 0x010,   ///< D3DCS_FRONT: z >= 0
  kClipBack = 0x020,    ///< D3DCS_BACK: z <= w
  kClipPlane0 = 0x040,  ///< D3DCS_PLANE0: Ax + By + Cz + Dw >= 0
  kClipAll = 0xFFF,     ///< D3DCS_ALL
};

/// The user clip planes of a device: coefficients in clip space, and D3DRS_CLIPPLANEENABLE.
struct UserClipPlanes {
  float planes[6][4] = {};
  std::uint32_t enable_mask = 0;  ///< bits above 5 have no effect
};

/// The clip code of one vertex. An inequality that contains NaN is not fulfilled. Computed in float
/// without fused operations, from left to right: ((Ax + By) + Cz) + Dw.
std::uint32_t ClipCode(const float (&position)[4], const UserClipPlanes& user_planes) noexcept;

/// D3DCLIPSTATUS9, with the values that it has before the first vertex. A bit of the union is set
/// if at least one vertex is outside of that plane; a bit of the intersection, if every vertex is,
/// so that nothing is drawn. An intersection of 0 does not prove that something is visible.
struct ClipStatus {
  std::uint32_t clip_union = 0;                   ///< OR of all codes
  std::uint32_t clip_intersection = 0xFFFFFFFFu;  ///< AND of all codes
};

/// Adds `count` vertices to `status`, as a draw call does, with exactly the ClipCode of each.
/// `positions` is 4 * count floats. `codes`, if not null, receives `count` clip codes. If
/// `clipping` (D3DRS_CLIPPING) is false, both members become 0 and so do the codes: the status then
/// contains no information.
void UpdateClipStatus(ClipStatus& status, const float* positions, std::size_t count,
                      const UserClipPlanes& user_planes, bool clipping,
                      std::uint16_t* codes = nullptr) noexcept;

}  // namespace clipc::runtime
