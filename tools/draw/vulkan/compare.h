// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "tools/draw/compare.h"
#include "tools/draw/vulkan/run.h"

namespace clipc::draw::vulkan {

// `expected` among what `spirv` writes, in that order. What is not written is a DrawError.
std::vector<Output> FindOutputs(const Spirv& spirv, const std::vector<const Expected*>& expected);

// Compiles clipc's GLSL for Vulkan with glslang, runs it and holds what comes out against what
// must.
Comparison CompareWithVulkan(const Runner& runner, const Shader& shader,
                             const std::vector<Expected>& expected, const RandomInputs& random,
                             const RandomOptions& draw, const Tolerance& tolerance);

}  // namespace clipc::draw::vulkan
