// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/gl/clip_switches.h"

#include <algorithm>

namespace clipc::runtime::gl {

ClipSwitches::ClipSwitches(const Functions& gl) noexcept : gl_(gl) {
  int max = 0;
  gl_.GetIntegerv(kMaxClipDistances, &max);
  max_planes_ = static_cast<std::uint32_t>(std::max(max, 0));
  for (std::uint32_t i = 0; i < std::min(max_planes_, kMaxClipPlanes); ++i) {
    if (gl_.IsEnabled(kClipDistance0 + i) != 0) before_ |= std::uint32_t{1} << i;
  }
  mask_ = before_;
}

ClipSwitches::~ClipSwitches() { Restore(); }

Status ClipSwitches::Bind(const Table& table) noexcept {
  if (table.lowering == Lowering::kLevel9) {
    return Status::Failure(Error::kWrongLowering,
                           "the shader writes no clip distances; Level9Binder sets its planes");
  }
  return Enable(table.enable_mask);
}

Status ClipSwitches::Bind(const ShaderVariant& variant) noexcept {
  return Enable((std::uint32_t{1} << variant.plane_count) - 1);
}

Status ClipSwitches::Enable(std::uint32_t mask) noexcept {
  const std::uint32_t limit = std::min(max_planes_, kMaxClipPlanes);
  if (mask >> limit != 0) {
    return Status::Failure(Error::kInvalidCall, "clip distances 0x%x; OpenGL has %u here", mask,
                           limit);
  }
  Switch(mask);
  return {};
}

void ClipSwitches::Restore() noexcept { Switch(before_); }

void ClipSwitches::Switch(std::uint32_t mask) noexcept {
  // Enabling comes first, so that no state in between has none enabled.
  for (const bool on : {true, false}) {
    for (std::uint32_t i = 0; (mask | mask_) >> i != 0; ++i) {
      const std::uint32_t bit = std::uint32_t{1} << i;
      if (((mask ^ mask_) & bit) == 0 || ((mask & bit) != 0) != on) continue;
      (on ? gl_.Enable : gl_.Disable)(kClipDistance0 + i);
    }
  }
  mask_ = mask;
}

}  // namespace clipc::runtime::gl
