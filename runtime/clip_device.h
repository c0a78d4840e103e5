// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>

namespace clipc::runtime {

// What Level9Binder needs of a device: two calls of IDirect3DDevice9, or what stands for them.
// Called on the thread that calls the binder. Neither function may throw; false means that the
// device refused, and nobody knows what it holds then.
class ClipDevice {
 public:
  // IDirect3DDevice9::SetClipPlane: `plane` is {A, B, C, D} in clip space; Ax + By + Cz + Dw >= 0
  // is kept.
  virtual bool SetClipPlane(std::uint32_t index, const float plane[4]) noexcept = 0;
  // SetRenderState(D3DRS_CLIPPLANEENABLE, mask): bit i enables plane i.
  virtual bool SetClipPlaneEnable(std::uint32_t mask) noexcept = 0;

 protected:
  ~ClipDevice() = default;
};

}  // namespace clipc::runtime
