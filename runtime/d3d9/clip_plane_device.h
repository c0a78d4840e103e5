// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>

#include <d3d9.h>
#include <windows.h>

#include "runtime/clip_device.h"

namespace clipc::runtime::d3d9 {

// A real IDirect3DDevice9 for Level9Binder. Drawing with a vertex shader (or with D3DFVF_XYZW), so
// that SetClipPlane takes planes of clip space; with the fixed function it would take them in world
// space.
//
// The device must outlive this object, which takes no reference. State that it found is not
// restored: Direct3D 9's own means for that is a state block. On the device's thread.
class ClipPlaneDevice final : public ClipDevice {
 public:
  explicit ClipPlaneDevice(IDirect3DDevice9& device) noexcept;

  // D3DCAPS9::MaxUserClipPlanes, for Level9Binder; 0 where the device does not tell.
  std::uint32_t max_planes() const noexcept { return max_planes_; }

  // Refuse what lies beyond max_planes() themselves: not every implementation does.
  bool SetClipPlane(std::uint32_t index, const float plane[4]) noexcept override;
  bool SetClipPlaneEnable(std::uint32_t mask) noexcept override;

 private:
  IDirect3DDevice9* device_;
  std::uint32_t max_planes_ = 0;
};

}  // namespace clipc::runtime::d3d9
