// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>

#include <d3d9.h>
#include <windows.h>

#include "../clip_device.h"

namespace clipc::runtime::d3d9 {

/// An IDirect3DDevice9 as the device of a Level9Binder. Draws must use a vertex shader (or
/// D3DFVF_XYZW), so that SetClipPlane takes planes in clip space; with the fixed function it takes
/// them in world space.
///
/// The device must outlive this object, which takes no reference, and is used on its own thread.
/// The state that it had is not restored; Direct3D 9 has state blocks for that.
class ClipPlaneDevice final : public ClipDevice {
 public:
  explicit ClipPlaneDevice(IDirect3DDevice9& device) noexcept;

  /// D3DCAPS9::MaxUserClipPlanes, for Level9Binder; 0 if the device does not report it.
  std::uint32_t max_planes() const noexcept { return max_planes_; }

  /// SetClipPlane and SetClipPlaneEnable refuse planes that are not below max_planes(), because not
  /// every implementation does.
  bool SetClipPlane(std::uint32_t index, const float plane[4]) noexcept override;
  bool SetClipPlaneEnable(std::uint32_t mask) noexcept override;

 private:
  IDirect3DDevice9* device_;
  std::uint32_t max_planes_ = 0;
};

}  // namespace clipc::runtime::d3d9
