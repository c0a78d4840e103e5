// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>

#include "../shader_variant.h"
#include "../status.h"
#include "../table.h"
#include "functions.h"

namespace clipc::runtime::gl {

/// The switches of GL_CLIP_DISTANCE0 to 5, set so that exactly those distances are enabled that the
/// shader writes. A distance that is enabled but not written is undefined in OpenGL; one that is
/// written but not enabled does not clip, except that Mesa's software driver clips with all of them
/// if none is enabled. A draw without planes therefore takes the shader variant that writes no
/// distances.
///
/// The context must be current in every call, the destructor included. Calls OpenGL only for a
/// change; while the object lives, no other code switches these capabilities. No allocation.
class ClipSwitches {
 public:
  /// Remembers the distances that are enabled now.
  explicit ClipSwitches(const Functions& gl) noexcept;
  /// Calls Restore().
  ~ClipSwitches();
  ClipSwitches(const ClipSwitches&) = delete;
  ClipSwitches& operator=(const ClipSwitches&) = delete;

  /// GL_MAX_CLIP_DISTANCES, also named GL_MAX_CLIP_PLANES.
  std::uint32_t max_planes() const noexcept { return max_planes_; }

  /// Enables the distances that the shader of `table` writes; call it before a draw with that
  /// shader. Errors: kWrongLowering for kLevel9, whose planes Level9Binder switches; those of
  /// Enable.
  Status Bind(const Table& table) noexcept;
  /// Enables the distances of one of the shaders that `clipc --variants` wrote with lowering
  /// kClipDistance; call it before a draw with that shader. Errors: those of Enable.
  Status Bind(const ShaderVariant& variant) noexcept;
  /// Enables GL_CLIP_DISTANCEi for each bit i of `mask` and disables the others. Errors:
  /// kInvalidCall if the mask has a bit that is not below max_planes() and kMaxClipPlanes; nothing
  /// is changed then.
  Status Enable(std::uint32_t mask) noexcept;

  /// Restores the state that the constructor found. The object can be used further.
  void Restore() noexcept;

 private:
  void Switch(std::uint32_t mask) noexcept;

  Functions gl_;
  std::uint32_t max_planes_ = 0;
  std::uint32_t before_ = 0;  ///< bits of the distances that the constructor found enabled
  std::uint32_t mask_ = 0;    ///< bits of the distances that are enabled now
};

}  // namespace clipc::runtime::gl
