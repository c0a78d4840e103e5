// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>

// What Direct3D 9 calls clip status (D3DCLIPSTATUS9), computed on the CPU: for every vertex the
// planes that it is outside of, and for a draw the union and the intersection of these codes. Pure
// functions: any thread, no allocation.
namespace clipc::runtime {

// The bits of a clip code, with the values of d3d9types.h. A position (x, y, z, w) in Direct3D clip
// space is outside
enum ClipCodeBit : std::uint32_t {
  kClipLeft = 0x001,    // D3DCS_LEFT: unless x >= -w
  kClipRight = 0x002,   // D3DCS_RIGHT: unless x <= w
  kClipTop = 0x004,     // D3DCS_TOP: unless y <= w
  kClipBottom = 0x008,  // D3DCS_BOTTOM: unless y >= -w
  kClipFront = 0x010,   // D3DCS_FRONT: unless z >= 0
  kClipBack = 0x020,    // D3DCS_BACK: unless z <= w
  kClipPlane0 =
      // D3DCS_PLANE0: unless Ax + By + Cz + Dw >= 0; D3DCS_PLANEi is kClipPlane0 << i, i up to 5
  0x040,
  kClipAll = 0xFFF,  // D3DCS_ALL
};

// "D3DCS_LEFT" of kClipLeft, and so on; a null pointer for anything but one bit of kClipAll.
const char* NameOfClipBit(std::uint32_t bit) noexcept;

// The user clip planes as the device holds them: coefficients in clip space, and
// D3DRS_CLIPPLANEENABLE.
struct UserClipPlanes {
  float planes[6][4] = {};
  std::uint32_t enable_mask = 0;  // bits above 5 do nothing
};

// The clip code of one vertex. NaN is outside of whatever it takes part in. Computed in float
// without fused operations, from left to right: ((Ax + By) + Cz) + Dw.
std::uint32_t ClipCode(const float (&position)[4], const UserClipPlanes& user_planes) noexcept;

// D3DCLIPSTATUS9.
struct ClipStatus {
  std::uint32_t clip_union = 0;  // OR of all codes: for each bit, at least one vertex is outside
  std::uint32_t clip_intersection =
      0xFFFFFFFFu;  // AND of all codes: for each bit, all vertices are outside
};

// Adds `count` vertices to `status`, as a draw call does; exactly ClipCode of each, only faster.
// `positions` is 4 * count floats. `codes`, where not null, gets the count clip codes. With
// `clipping` false (D3DRS_CLIPPING) both members become 0, and so do the codes.
void UpdateClipStatus(ClipStatus& status, const float* positions, std::size_t count,
                      const UserClipPlanes& user_planes, bool clipping,
                      std::uint16_t* codes = nullptr) noexcept;

// What a status says of the object whose vertices it was computed from, initial values first.
enum class ClipVerdict : std::uint8_t {
  kUnknown,  // no vertex was counted, or clipping was off: the numbers say nothing
  kInside,   // nothing needs clipping
  // some vertices are outside of the planes in clip_union; the object may still be invisible
  kNeedsClip,
  kOutside,  // all vertices are outside of one plane: nothing would be drawn
};
ClipVerdict VerdictOf(const ClipStatus& status, bool clipping) noexcept;

}  // namespace clipc::runtime
