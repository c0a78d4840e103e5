// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "backend-glsl/other_stage.h"
#include "backend-glsl/reach.h"
#include "backend-glsl/target.h"
#include "ir/program.h"

// The bindings of the buffers and objects of a Vulkan shader. Direct3D numbers constant buffers,
// textures and samplers apart; a Vulkan set has one row of bindings. Register n becomes binding n +
// the shift of its letter, one of those below unless the target has other rules; the space becomes
// the set. A space above the highest set becomes the lowest set that no other space has, unless the
// user says how registers are bound. [[vk::binding]] comes before all of that. An object that has
// neither it nor a written register moves to the next free binding if its own is taken, as in DXC.
// A shader that is compiled alone has all bindings that follow from registers higher by
// Target::BaseOf(stage).
// A stage has the bindings of those that are laid out before it for what they share, and moves what
// is in their way.
namespace clipc::glsl {

inline constexpr std::uint32_t kVulkanShiftB = 0;
inline constexpr std::uint32_t kVulkanShiftS = 16;   // b0 to b15 come before: Direct3D 11 has 14
inline constexpr std::uint32_t kVulkanShiftT = 32;   // s0 to s15
inline constexpr std::uint32_t kVulkanShiftU = 160;  // t0 to t127

// The highest set that glslang accepts: layoutSetEnd.
inline constexpr std::uint32_t kHighestSet = 0x3e;

class Descriptors {
 public:
  // Keeps references to the program and the target.
  Descriptors(const ir::Program& program, const Reached& reached, const Target& target,
              OtherStages others = {});

  // The set and binding of the buffer or resource of the program that has this register.
  ir::Descriptor Of(const ir::Register& reg) const;

  // Whether the place that follows from the register is taken, and the object is elsewhere.
  bool IsMoved(const ir::Register& reg) const { return moved_.contains(&reg); }

  // Whether the set of the register is not its space, which is too high.
  bool IsRenumbered(const ir::Register& reg) const;

 private:
  using Taken = std::set<std::pair<std::uint32_t, std::uint32_t>>;  // sets and bindings

  void TakeFromOther(const ir::Program& program, const OtherStage& other, Taken& taken);
  void RenumberSpaces(const std::vector<const ir::Register*>& all, OtherStages others);
  ir::Descriptor Plain(const ir::Register& reg) const;

  const Target& target_;
  std::vector<BindingRule> rules_;             // those of the target that are for this stage
  std::map<const ir::Register*, char> kinds_;  // kImages, kStorageBlocks
  const std::uint32_t base_, plain_set_;
  const ir::Register* globals_ = nullptr;
  std::map<const ir::Register*, ir::Descriptor> moved_;
  std::map<std::uint32_t, std::uint32_t> renumbered_;  // the sets of spaces that are too high
};

}  // namespace clipc::glsl
