// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ir/program.h"

namespace clipc::spirv {

// The members of a constant buffer, by their numbers, that a block for Vulkan has at the offsets
// which Direct3D's rules gave them: all of them, or where these do not fit, those that are read.
// `is_relaxed`: vectors may lie at every multiple of their components' size (Vulkan 1.1, and
// VK_KHR_relaxed_block_layout). nullopt where the members that are read do not fit: nothing may lie
// in the last row of an array, a struct or a matrix ("Offset and Stride Assignment" in Vulkan's
// specification), which Direct3D lets the next member use.
std::optional<std::vector<std::uint32_t>> FittingMembers(const ir::Program& program,
                                                         const ir::Cbuffer& cbuffer,
                                                         const std::vector<bool>& is_read,
                                                         bool is_relaxed);

}  // namespace clipc::spirv
