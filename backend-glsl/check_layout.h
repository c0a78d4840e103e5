// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>

#include "base/diagnostics.h"
#include "ir/program.h"

namespace clipc::glsl {

// The layouts of buffers that dxc has for Vulkan: std140 and std430 by -fvk-use-gl-layout, without
// padding by -fvk-use-scalar-layout. clipc keeps Direct3D's.
enum class BufferLayout : std::uint8_t { kDirect3D, kGl, kScalar };

// Reports each buffer that `main` reaches and that lies otherwise in the layout.
void CheckBufferLayout(const ir::Program& program, BufferLayout layout, Diagnostics& diagnostics);

}  // namespace clipc::glsl
