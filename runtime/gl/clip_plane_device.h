// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>

#include "runtime/clip_device.h"
#include "runtime/gl/clip_switches.h"
#include "runtime/gl/functions.h"

namespace clipc::runtime::gl {

// OpenGL's own clip planes in the part of Direct3D 9's, for Level9Binder: glClipPlane and
// GL_CLIP_PLANEi on a context of the compatibility profile, with shaders of lowering level9 that
// write gl_ClipVertex (targets glsl120 and glsl130).
//
// glClipPlane takes a plane of object space and multiplies it by the inverse of the current
// modelview matrix; gl_ClipVertex is dotted with the result. clipc's gl_ClipVertex is the position
// in Direct3D clip space, and so the matrix must be the identity: SetClipPlane makes it that for
// the call, and leaves matrix and matrix mode as they were.
//
// The context must be current in every call, the destructor included, which restores planes and
// switches as the constructor found them.
class ClipPlaneDevice final : public ClipDevice {
 public:
  // `gl` must have has_clip_planes(); without, every SetClipPlane is refused.
  explicit ClipPlaneDevice(const Functions& gl) noexcept;
  ~ClipPlaneDevice();
  ClipPlaneDevice(const ClipPlaneDevice&) = delete;
  ClipPlaneDevice& operator=(const ClipPlaneDevice&) = delete;

  // For Level9Binder.
  std::uint32_t max_planes() const noexcept { return switches_.max_planes(); }

  bool SetClipPlane(std::uint32_t index, const float plane[4]) noexcept override;
  bool SetClipPlaneEnable(std::uint32_t mask) noexcept override;

 private:
  void SetEquation(std::uint32_t index, const double (&equation)[4]) noexcept;

  Functions gl_;
  ClipSwitches switches_;
  std::uint32_t changed_ = 0;              // bit i: plane i was set
  double before_[kMaxClipPlanes][4] = {};  // what it was
};

}  // namespace clipc::runtime::gl
