// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/check_bindings.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "backend-glsl/descriptors.h"
#include "legalize/split_arrays.h"

namespace clipc::glsl {

using namespace ir;

namespace {

// The highest binding that glslang takes: layoutBindingEnd.
constexpr std::uint32_t kHighestBinding = 0xfffe;

}  // namespace

void CheckBindings(const Program& program, const Reached& reached, const Target& target,
                   Diagnostics& diagnostics) {
  const Descriptors descriptors(program, reached, target);
  struct Taken {
    std::string name;
    Span span;
    ObjectCategory category;
    bool is_chosen;  // [[vk::binding]] gives the place
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, Taken> taken;
  std::set<std::uint32_t> renumbered;
  bool may_differ = target.bindings.replaces_tool;
  const legalize::ArraySplit split = target.Needs().split_arrays;
  const auto take = [&](const Register& reg, const std::string& name, Span span,
                        ObjectCategory category, std::uint32_t element = 0) {
    Descriptor at = descriptors.Of(reg);
    at.binding += element;
    if (may_differ && reg.is_explicit && !reg.descriptor && at.binding != reg.number + element) {
      diagnostics.Report(span, diag::TargetBindingDiffers, name, at.binding, reg.number + element);
      may_differ = false;
    }
    if (at.binding > kHighestBinding || at.set > kHighestSet)
      diagnostics.Report(span, diag::TargetBindingTooHigh, name, at.binding, at.set,
                         kHighestBinding, kHighestSet);
    if (descriptors.IsRenumbered(reg) && renumbered.insert(reg.space).second)
      diagnostics.Report(span, diag::TargetSetRenumbered, name, reg.space, kHighestSet);
    const auto [found, is_free] = taken.try_emplace(
        {at.set, at.binding}, Taken{name, span, category, reg.descriptor.has_value()});
    Taken& other = found->second;
    const bool may_combine =
        target.bindings.combines_samplers || (other.is_chosen && reg.descriptor.has_value());
    if (!is_free && may_combine &&
        std::minmax({other.category, category}) ==
            std::pair(ObjectCategory::kTexture, ObjectCategory::kSampler)) {
      other.category = ObjectCategory::kCombinedSampler;
    } else if (!is_free) {
      diagnostics.Report(span, diag::TargetBindingsCollide, other.name, name, at.binding, at.set)
          .Note(other.span, diag::DeclaredHere, other.name);
    }
  };
  for (CbufferId id : program.cbuffers.ids()) {
    const ir::Cbuffer& cbuffer = program.cbuffers[id];
    if (reached.Has(id) && !cbuffer.is_push_constant)
      take(cbuffer.reg, cbuffer.name, cbuffer.span, ObjectCategory::kOther);
  }
  for (const Resource& resource : program.resources) {
    const Var& var = program.vars[resource.var];
    const ObjectCategory category =
        InfoOf(program.types[program.types.Innermost(var.type)].object).category;
    if (!reached.Has(resource.var)) continue;
    const std::uint32_t count = std::max(legalize::SplitCount(program, split, resource.var), 1u);
    // The elements would move one by one.
    if (count > 1 && descriptors.IsMoved(resource.reg)) {
      diagnostics.Report(var.span, diag::Unsupported,
                         "`-fspv-flatten-resource-arrays` of `" + var.name +
                             "`, an array without a register whose binding is taken,");
      continue;
    }
    for (std::uint32_t i = 0; i < count; ++i) take(resource.reg, var.name, var.span, category, i);
  }
}

}  // namespace clipc::glsl
