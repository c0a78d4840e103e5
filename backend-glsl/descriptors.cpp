// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/descriptors.h"

#include <algorithm>
#include <ranges>
#include <set>
#include <utility>
#include <vector>

namespace clipc::glsl {

Descriptors::Descriptors(const ir::Program& program, const Reached& reached, const Target& target)
    : target_(target) {
  if (!target.IsVulkan()) return;
  std::vector<const ir::Register*> all;
  for (const ir::CbufferId id : program.cbuffers.ids()) {
    const ir::Cbuffer& cbuffer = program.cbuffers[id];
    if (reached.Has(id) && !cbuffer.is_push_constant) all.push_back(&cbuffer.reg);
  }
  for (const ir::Resource& resource : program.resources) {
    if (reached.Has(resource.var)) all.push_back(&resource.reg);
  }
  const auto has_own = [](const ir::Register* reg) { return reg->descriptor.has_value(); };
  if (std::ranges::none_of(all, has_own)) return;
  std::set<std::pair<std::uint32_t, std::uint32_t>> taken;
  const auto stays = [&](const ir::Register* reg) { return has_own(reg) || reg->is_explicit; };
  for (const ir::Register* reg : all | std::views::filter(stays)) {
    const ir::Descriptor at = Plain(*reg);
    taken.emplace(at.set, at.binding);
  }
  for (const ir::Register* reg : all) {
    if (stays(reg)) continue;
    ir::Descriptor at = Plain(*reg);
    while (!taken.emplace(at.set, at.binding).second) ++at.binding;
    moved_.emplace(reg, at);
  }
}

ir::Descriptor Descriptors::Of(const ir::Register& reg) const {
  const auto moved = moved_.find(&reg);
  return moved == moved_.end() ? Plain(reg) : moved->second;
}

ir::Descriptor Descriptors::Plain(const ir::Register& reg) const {
  if (reg.descriptor) return *reg.descriptor;
  for (const BindingShift& given : target_.binding_shifts | std::views::reverse) {
    if (given.letter == reg.letter && given.space.value_or(reg.space) == reg.space)
      return {reg.number + given.shift, reg.space};
  }
  switch (reg.letter) {
    case 'b': return {reg.number + kVulkanShiftB, reg.space};
    case 's': return {reg.number + kVulkanShiftS, reg.space};
    case 'u': return {reg.number + kVulkanShiftU, reg.space};
    default: return {reg.number + kVulkanShiftT, reg.space};
  }
}

}  // namespace clipc::glsl
