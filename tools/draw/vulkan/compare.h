// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "tools/draw/compare.h"
#include "tools/draw/vulkan/run.h"

namespace clipc::draw::vulkan {

// The outputs of `spirv` that are `expected`, in that order. Throws DrawError where one is not
// written.
std::vector<Output> FindOutputs(const Spirv& spirv, const std::vector<const Expected*>& expected);

// Compiles clipc's GLSL for Vulkan with glslang, runs it and compares its outputs with the expected
// ones.
Comparison CompareWithVulkan(const Runner& runner, const Trial& trial);

}  // namespace clipc::draw::vulkan
