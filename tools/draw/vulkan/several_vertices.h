// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "tools/draw/compare.h"
#include "tools/draw/vulkan/run.h"

namespace clipc::draw::vulkan {

// Runs the shader, which reads several vertices, after shaders that pass the random ones on, and
// before one that takes its outputs to where they are captured. Returns those outputs in their
// order: of the vertices that a geometry shader emits, of the control points that a hull shader
// writes, patch after patch, or of the points of a domain.
std::vector<Captured> CaptureSeveral(const Runner& runner, const Spirv& spirv, const Trial& trial,
                                     const std::vector<const Expected*>& outputs, DrawCall call);

}  // namespace clipc::draw::vulkan
