// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>

#include "../clip_device.h"
#include "clip_switches.h"
#include "functions.h"

namespace clipc::runtime::gl {

/// OpenGL's own clip planes as the device of a Level9Binder: glClipPlane and GL_CLIP_PLANEi on a
/// context of the compatibility profile, for shaders of lowering level9 that write gl_ClipVertex
/// (targets glsl120 and glsl130).
///
/// glClipPlane multiplies a plane by the inverse of the current modelview matrix, and OpenGL dots
/// gl_ClipVertex with the result. clipc's gl_ClipVertex is the position in Direct3D clip space, so
/// the matrix must be the identity: SetClipPlane sets it for the call and restores matrix and
/// matrix mode.
///
/// The context must be current in every call, the destructor included, which restores planes and
/// switches as the constructor found them.
class ClipPlaneDevice final : public ClipDevice {
 public:
  /// If has_clip_planes() of `gl` is false, SetClipPlane refuses every call.
  explicit ClipPlaneDevice(const Functions& gl) noexcept;
  ~ClipPlaneDevice();
  ClipPlaneDevice(const ClipPlaneDevice&) = delete;
  ClipPlaneDevice& operator=(const ClipPlaneDevice&) = delete;

  /// The number of planes that the context supports, for Level9Binder.
  std::uint32_t max_planes() const noexcept { return switches_.max_planes(); }

  bool SetClipPlane(std::uint32_t index, const float plane[4]) noexcept override;
  bool SetClipPlaneEnable(std::uint32_t mask) noexcept override;

 private:
  void SetEquation(std::uint32_t index, const double (&equation)[4]) noexcept;

  Functions gl_;
  ClipSwitches switches_;
  std::uint32_t changed_ = 0;              ///< bit i: plane i was set
  double before_[kMaxClipPlanes][4] = {};  ///< the planes to restore, for the bits of changed_
};

}  // namespace clipc::runtime::gl
