// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

#include "base/diagnostics.h"
#include "compiler/effect/effect_facts.h"

namespace clipc {

// A state of a pass for Vulkan: a member of the structs of a pipeline, and its enumerator, mask or
// flag, or its number.
struct VulkanState {
  std::string_view member;  // "depthCompareOp"
  std::variant<std::uint32_t, float> value;
};

// The states that a pass sets to constants, in the order of vulkan_states.def. The front faces are
// those of Direct3D's image, whose first row is the upper one.
std::vector<VulkanState> ReadVulkanStates(const EffectFacts& effect, const ast::EffectPass& pass);

// Warns of the states of the effect's passes that ReadVulkanStates leaves out.
void CheckVulkanStates(const EffectFacts& effect, Diagnostics& diagnostics);

}  // namespace clipc
