// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/bindings.h"

#include <ranges>

#include "backend-glsl/text.h"

namespace clipc::glsl {

namespace {

std::uint32_t FreeBinding(Bindings& taken, std::uint32_t wanted, std::uint32_t count) {
  const auto is_free = [&](std::uint32_t first) {
    const auto next = taken.lower_bound(first);
    return next == taken.end() || *next - first >= count;
  };
  if (!is_free(wanted)) {
    for (wanted = 0; !is_free(wanted);) ++wanted;
  }
  for (std::uint32_t i = 0; i < count; ++i) taken.insert(wanted + i);
  return wanted;
}

}  // namespace

std::uint32_t VulkanBinding(const ir::Register& reg, const Target& target) {
  for (const BindingShift& given : target.binding_shifts | std::views::reverse) {
    if (given.letter == reg.letter && given.space.value_or(reg.space) == reg.space)
      return reg.number + given.shift;
  }
  switch (reg.letter) {
    case 'b': return reg.number + kVulkanShiftB;
    case 's': return reg.number + kVulkanShiftS;
    case 'u': return reg.number + kVulkanShiftU;
    default: return reg.number + kVulkanShiftT;
  }
}

std::string LayoutText(std::initializer_list<std::string_view> qualifiers) {
  std::string text;
  for (const std::string_view qualifier : qualifiers) {
    if (!qualifier.empty()) Append(text, text.empty() ? "layout(" : ", ", qualifier);
  }
  if (!text.empty()) text += ") ";
  return text;
}

std::string RegisterText(const ir::Register& reg) {
  return reg.letter + std::to_string(reg.number);
}

std::string Bind(const Context& context, GlslInfo::Place& place,
                 const ir::BlockDeclaration& declared) {
  if (context.target.IsVulkan()) place.set = declared.set;
  if (context.target.IsVulkan() || context.Has(Feature::kBindings))
    place.binding = declared.binding;
  const std::string set =
      place.set ? Concat("set = ", std::to_string(*place.set), place.binding ? ", " : "") : "";
  return place.binding ? Concat(set, "binding = ", std::to_string(*place.binding)) : set;
}

std::string Bind(const Context& context, GlslInfo::Place& place, const ir::Register& reg,
                 Bindings& taken, std::uint32_t count) {
  std::string set;
  if (context.target.IsVulkan()) {
    place.set = reg.space;
    place.binding = VulkanBinding(reg, context.target);
    set = Concat("set = ", std::to_string(reg.space), ", ");
  } else if (context.Has(Feature::kBindings)) {
    place.binding = FreeBinding(taken, reg.number, count);
  } else {
    return "";
  }
  return Concat(set, "binding = ", std::to_string(*place.binding));
}

}  // namespace clipc::glsl
