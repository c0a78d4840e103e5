// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>

namespace clipc::runtime {

/// The device that Level9Binder sets planes on: two functions of IDirect3DDevice9, or their
/// replacement. They are called on the thread that calls the binder, and do not throw. They return
/// false if the device refuses the call; the state that it holds is then unknown.
class ClipDevice {
 public:
  /// IDirect3DDevice9::SetClipPlane: `plane` is {A, B, C, D} in clip space; Ax + By + Cz + Dw >= 0
  /// is kept.
  virtual bool SetClipPlane(std::uint32_t index, const float plane[4]) noexcept = 0;
  /// SetRenderState(D3DRS_CLIPPLANEENABLE, mask): bit i enables plane i.
  virtual bool SetClipPlaneEnable(std::uint32_t mask) noexcept = 0;

 protected:
  ~ClipDevice() = default;
};

}  // namespace clipc::runtime
