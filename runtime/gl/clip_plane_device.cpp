// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/gl/clip_plane_device.h"

namespace clipc::runtime::gl {

ClipPlaneDevice::ClipPlaneDevice(const Functions& gl) noexcept : gl_(gl), switches_(gl) {}

ClipPlaneDevice::~ClipPlaneDevice() {
  for (std::uint32_t i = 0; changed_ >> i != 0; ++i) {
    if ((changed_ >> i & 1) != 0) SetEquation(i, before_[i]);
  }
}

bool ClipPlaneDevice::SetClipPlane(std::uint32_t index, const float plane[4]) noexcept {
  if (!gl_.has_clip_planes() || index >= max_planes() || index >= kMaxClipPlanes) return false;
  if ((changed_ >> index & 1) == 0) {
    gl_.GetClipPlane(kClipDistance0 + index, before_[index]);
    changed_ |= std::uint32_t{1} << index;
  }
  SetEquation(index, {plane[0], plane[1], plane[2], plane[3]});
  return true;
}

bool ClipPlaneDevice::SetClipPlaneEnable(std::uint32_t mask) noexcept {
  return switches_.Enable(mask).ok();
}

void ClipPlaneDevice::SetEquation(std::uint32_t index, const double (&equation)[4]) noexcept {
  int mode = 0;
  gl_.GetIntegerv(kMatrixMode, &mode);
  gl_.MatrixMode(kModelView);
  gl_.PushMatrix();
  gl_.LoadIdentity();
  gl_.ClipPlane(kClipDistance0 + index, equation);
  gl_.PopMatrix();
  gl_.MatrixMode(static_cast<unsigned>(mode));
}

}  // namespace clipc::runtime::gl
