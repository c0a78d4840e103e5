// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/d3d9/clip_plane_device.h"

namespace clipc::runtime::d3d9 {

ClipPlaneDevice::ClipPlaneDevice(IDirect3DDevice9& device) noexcept : device_(&device) {
  D3DCAPS9 caps = {};
  if (SUCCEEDED(device_->GetDeviceCaps(&caps))) max_planes_ = caps.MaxUserClipPlanes;
}

bool ClipPlaneDevice::SetClipPlane(std::uint32_t index, const float plane[4]) noexcept {
  return index < max_planes_ && SUCCEEDED(device_->SetClipPlane(index, plane));
}

bool ClipPlaneDevice::SetClipPlaneEnable(std::uint32_t mask) noexcept {
  const bool fits = max_planes_ >= 32 || mask >> max_planes_ == 0;
  return fits && SUCCEEDED(device_->SetRenderState(D3DRS_CLIPPLANEENABLE, mask));
}

}  // namespace clipc::runtime::d3d9
