// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/bindings.h"

#include <optional>

#include "backend-glsl/text.h"

namespace clipc::glsl {

namespace {

std::optional<std::uint32_t> FreeBinding(Bindings& bindings, const ir::Register& reg,
                                         std::uint32_t count) {
  const auto is_free_of = [&](const std::set<std::uint32_t>& some, std::uint32_t first) {
    const auto next = some.lower_bound(first);
    return next == some.end() || *next - first >= count;
  };
  const auto has_room = [&](std::uint32_t first) {
    return first < bindings.end && count <= bindings.end - first;
  };
  const auto is_free = [&](std::uint32_t first) {
    return has_room(first) && is_free_of(bindings.taken, first) &&
           is_free_of(bindings.reserved, first);
  };
  std::uint32_t first = reg.descriptor ? reg.descriptor->binding : bindings.base + reg.number;
  const bool is_its_own = reg.descriptor && has_room(first) && is_free_of(bindings.taken, first);
  if (!is_its_own && !is_free(first)) {
    for (first = bindings.base; !is_free(first); ++first) {
      if (!has_room(first)) return {};
    }
  }
  for (std::uint32_t i = 0; i < count; ++i) bindings.taken.insert(first + i);
  return first;
}

}  // namespace

void Bindings::Reserve(const ir::Register& reg, std::uint32_t count) {
  for (std::uint32_t i = 0; reg.descriptor && i < count; ++i)
    reserved.insert(reg.descriptor->binding + i);
}

void Bindings::Take(const GlslInfo::Binding& place) {
  for (std::uint32_t i = 0; place.binding && i < place.count; ++i) taken.insert(*place.binding + i);
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

void Bind(WriterContext& context, GlslInfo::Binding& place, const ir::BlockDeclaration& declared) {
  if (context.target.IsVulkan()) place.set = declared.set;
  // A linker compares the bindings, which SPIRV-Cross writes in GLSL 3.30 too.
  const bool is_extended =
      declared.binding && !context.target.IsEs() && !context.Has(Feature::kBindings);
  if (is_extended) context.Require("GL_ARB_shading_language_420pack");
  if (context.target.IsVulkan() || context.Has(Feature::kBindings) || is_extended)
    place.binding = declared.binding;
}

void Bind(const WriterContext& context, GlslInfo::Binding& place, const ir::Register& reg,
          Bindings& taken, const GlslInfo::Binding* written) {
  if (context.target.IsVulkan()) {
    const ir::Descriptor descriptor = context.descriptors.Of(reg);
    place.set = descriptor.set;
    place.binding = descriptor.binding;
  } else if (context.Has(Feature::kBindings)) {
    place.binding = written ? written->binding : FreeBinding(taken, reg, place.count);
  }
}

std::string PlaceText(const GlslInfo::Binding& place) {
  std::string text;
  if (place.set) Append(text, "set = ", *place.set, place.binding ? ", " : "");
  if (place.binding) Append(text, "binding = ", *place.binding);
  return text;
}

}  // namespace clipc::glsl
