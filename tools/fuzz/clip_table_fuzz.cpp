// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Gives any bytes to the runtime's table reader, and any table to the binder: either there is an
// error with a message, or the planes are such that a device can take them.
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "runtime/level9_binder.h"
#include "runtime/table.h"

namespace {

class CheckingDevice final : public clipc::runtime::ClipDevice {
 public:
  bool SetClipPlane(std::uint32_t index, const float plane[4]) noexcept override {
    if (index >= clipc::runtime::kMaxClipPlanes) std::abort();
    for (int i = 0; i < 4; ++i) {
      if (!std::isfinite(plane[i])) std::abort();
    }
    return true;
  }
  bool SetClipPlaneEnable(std::uint32_t mask) noexcept override {
    if (mask >> clipc::runtime::kMaxClipPlanes != 0) std::abort();
    return true;
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const clipc::runtime::Result<clipc::runtime::Table> table = clipc::runtime::ReadTable(data, size);
  if (!table.ok()) {
    if (table.status.message()[0] == '\0') std::abort();
    return 0;
  }
  // The input itself as the bytes of the first four constant buffers.
  clipc::runtime::BoundBuffer buffers[4];
  for (std::uint32_t i = 0; i < 4; ++i) buffers[i] = {i, 0, data, size};
  CheckingDevice device;
  clipc::runtime::Level9Binder binder(device, clipc::runtime::kMaxClipPlanes);
  const clipc::runtime::Status status = binder.Bind(table.value, buffers, 4);
  if (status.ok() == (status.message()[0] != '\0')) std::abort();
  return 0;
}
