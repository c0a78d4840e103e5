// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/descriptors.h"

#include <algorithm>
#include <iterator>
#include <ranges>
#include <vector>

#include "backend-glsl/glsl_info.h"

namespace clipc::glsl {

Descriptors::Descriptors(const ir::Program& program, const Reached& reached, const Target& target,
                         OtherStages others)
    : target_(target),
      base_(target.BaseOf(program.stage)),
      plain_set_(target.bindings.plain_sets[static_cast<std::size_t>(program.stage)]) {
  if (!target.IsVulkan()) return;
  std::ranges::copy_if(target.bindings.rules, std::back_inserter(rules_), [&](const auto& rule) {
    return rule.stage.value_or(program.stage) == program.stage;
  });
  std::vector<const ir::Register*> all;
  for (const ir::CbufferId id : program.cbuffers.ids()) {
    const ir::Cbuffer& cbuffer = program.cbuffers[id];
    if (reached.Has(id) && !cbuffer.is_push_constant) all.push_back(&cbuffer.reg);
    if (cbuffer.kind == ir::CbufferKind::kGlobals) globals_ = &cbuffer.reg;
  }
  for (const ir::Resource& resource : program.resources) {
    if (!reached.Has(resource.var)) continue;
    all.push_back(&resource.reg);
    const ir::TypeId type = program.types.Innermost(program.vars[resource.var].type);
    const ir::ObjectKind kind = program.types[type].object;
    if (IsImage(kind)) kinds_.emplace(&resource.reg, kImages);
    if (IsStorageBuffer(kind)) kinds_.emplace(&resource.reg, kStorageBlocks);
  }
  RenumberSpaces(all, others);
  const bool bound_by_option = target.bindings.globals.has_value();
  Taken taken;
  for (const OtherStage& other : others) {
    if (other.laid && !target.bindings.sets_by_stage) TakeFromOther(program, other, taken);
  }
  const Taken theirs = taken;
  // Where the user says how registers are bound, the host binds them so.
  const bool has_rules = !rules_.empty();
  const auto is_free = [&](const ir::Register& reg) {
    const ir::Descriptor at = Plain(reg);
    return has_rules || !theirs.contains({at.set, at.binding});
  };
  const auto stays = [&](const ir::Register* reg) {
    const bool is_placed = reg->is_explicit || (reg == globals_ && bound_by_option);
    return reg->descriptor || moved_.contains(reg) || (is_placed && is_free(*reg));
  };
  // A sampler is not in the way of the texture with which the host combines it.
  Taken taken_by_samplers;
  const auto take = [&](const ir::Register& reg, const ir::Descriptor& at) {
    const bool is_combined = target.bindings.combines_samplers && reg.letter == 's';
    return (is_combined ? taken_by_samplers : taken).emplace(at.set, at.binding).second;
  };
  for (const ir::Register* reg : all | std::views::filter(stays)) take(*reg, Plain(*reg));
  for (const ir::Register* reg : all) {
    if (stays(reg)) continue;
    ir::Descriptor at = Plain(*reg);
    while (!take(*reg, at)) ++at.binding;
    moved_.emplace(reg, at);
  }
}

void Descriptors::RenumberSpaces(const std::vector<const ir::Register*>& all, OtherStages others) {
  if (!rules_.empty()) return;  // the host binds them by these rules
  std::set<std::uint32_t> used, far;
  for (const ir::Register* reg : all) {
    const std::uint32_t set = Plain(*reg).set;
    const bool is_far = set > kHighestSet && !reg->descriptor && set == reg->space;
    (is_far ? far : used).insert(set);
  }
  if (far.empty()) return;
  const auto take = [&](const GlslInfo::Binding& place) { used.insert(place.set.value_or(0)); };
  for (const OtherStage& other : others) {
    if (!other.laid) continue;
    std::ranges::for_each(other.laid->blocks, take);
    std::ranges::for_each(other.laid->objects, take);
  }
  std::uint32_t next = 0;
  for (const std::uint32_t space : far) {
    while (used.contains(next)) ++next;
    renumbered_.emplace(space, next++);
  }
}

bool Descriptors::IsRenumbered(const ir::Register& reg) const {
  return !reg.descriptor && !moved_.contains(&reg) && renumbered_.contains(reg.space) &&
         Plain(reg).set == renumbered_.at(reg.space);
}

// Gives what both stages share the other's place. Adds all places that the other stage has.
void Descriptors::TakeFromOther(const ir::Program& program, const OtherStage& other, Taken& taken) {
  const auto take = [&](const GlslInfo::Binding& place, const ir::Register* reg) {
    if (!place.binding) return;
    taken.emplace(place.set.value_or(0), *place.binding);
    if (reg) moved_.emplace(reg, ir::Descriptor{*place.binding, place.set.value_or(0)});
  };
  for (const GlslInfo::UniformBlock& block : other.laid->blocks) {
    const ir::Register* shared = nullptr;
    for (const ir::CbufferId id : program.cbuffers.ids()) {
      if (other.cbuffers[id.index] == block.cbuffer) shared = &program.cbuffers[id].reg;
    }
    take(block, shared);
  }
  for (const GlslInfo::Object& object : other.laid->objects) {
    const ir::VarId theirs = object.texture ? object.texture : object.sampler;
    const ir::Register* shared = nullptr;
    for (const ir::Resource& resource : program.resources) {
      if (other.vars[resource.var.index] == theirs) shared = &resource.reg;
    }
    take(object, shared);
  }
}

ir::Descriptor Descriptors::Of(const ir::Register& reg) const {
  const auto moved = moved_.find(&reg);
  return moved == moved_.end() ? Plain(reg) : moved->second;
}

ir::Descriptor Descriptors::Plain(const ir::Register& reg) const {
  if (reg.descriptor) return *reg.descriptor;
  const BindingRules& rules = target_.bindings;
  if (&reg == globals_ && rules.globals) return *rules.globals;
  const bool is_unplaced = !reg.is_explicit && rules.unplaced_set;
  const auto far = is_unplaced ? renumbered_.end() : renumbered_.find(reg.space);
  const std::uint32_t space = is_unplaced                ? *rules.unplaced_set
                              : far != renumbered_.end() ? far->second
                              : reg.space == 0           ? plain_set_
                                                         : reg.space;
  const auto kind = kinds_.find(&reg);
  const char kind_letter = kind == kinds_.end() ? reg.letter : kind->second;
  for (const BindingRule& rule : rules_ | std::views::reverse) {
    if ((rule.letter != reg.letter && rule.letter != kind_letter) ||
        rule.number.value_or(reg.number) != reg.number ||
        rule.space.value_or(reg.space) != reg.space)
      continue;
    return {rule.binding + (rule.number ? 0 : reg.number + base_), rule.set.value_or(space)};
  }
  const std::uint32_t number = reg.number + base_;
  switch (reg.letter) {
    case 'b': return {number + kVulkanShiftB, space};
    case 's': return {number + kVulkanShiftS, space};
    case 'u': return {number + kVulkanShiftU, space};
    default: return {number + kVulkanShiftT, space};
  }
}

}  // namespace clipc::glsl
