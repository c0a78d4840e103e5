// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>

#include "runtime/gl/functions.h"
#include "runtime/shader_variant.h"
#include "runtime/status.h"
#include "runtime/table.h"

namespace clipc::runtime::gl {

// GL_CLIP_DISTANCE0 .. 5, switched so that exactly the distances are enabled that the shader
// writes. One that is enabled but not written is undefined in OpenGL; one that is written but not
// enabled does not clip, except that Mesa's software driver clips with all of them where none is
// enabled. So a shader that writes distances has at least one enabled, and a draw without planes
// takes the shader variant without.
//
// The context must be current in every call, the destructor included. Calls OpenGL only where
// something changes; while the object lives, nobody else switches what it switched. No allocation.
class ClipSwitches {
 public:
  // Remembers what is enabled now.
  explicit ClipSwitches(const Functions& gl) noexcept;
  // Restores it.
  ~ClipSwitches();
  ClipSwitches(const ClipSwitches&) = delete;
  ClipSwitches& operator=(const ClipSwitches&) = delete;

  // GL_MAX_CLIP_DISTANCES, which GL_MAX_CLIP_PLANES is another name of.
  std::uint32_t max_planes() const noexcept { return max_planes_; }

  // Before a draw with the shader of `table`; any lowering but kLevel9, whose planes Level9Binder
  // switches. Errors: kWrongLowering; as Enable.
  Status Bind(const Table& table) noexcept;
  // Before a draw with one of the shaders that `clipc --variants` wrote with lowering
  // kClipDistance. Errors: as Enable.
  Status Bind(const ShaderVariant& variant) noexcept;
  // Bit i enables GL_CLIP_DISTANCEi; the others are disabled. Errors: kInvalidCall where the mask
  // has a bit that is not below max_planes() or kMaxClipPlanes; then nothing is changed.
  Status Enable(std::uint32_t mask) noexcept;

  // As when the object was made. The next Enable begins from there.
  void Restore() noexcept;

 private:
  void Switch(std::uint32_t mask) noexcept;

  Functions gl_;
  std::uint32_t max_planes_ = 0;
  std::uint32_t before_ = 0;  // what to restore
  std::uint32_t mask_ = 0;    // what is enabled
};

}  // namespace clipc::runtime::gl
