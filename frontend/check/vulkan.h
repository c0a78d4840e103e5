// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// The attributes [[vk::...]], as "Vulkan specific attributes" in DXC's docs/SPIR-V.rst has them.
namespace clipc::check {

// [[vk::binding(number, set)]], of which the set may be left out. Nothing without one, and after an
// error, which was reported.
std::optional<Descriptor> DescriptorOf(Context& context, List<ast::Attr> attributes);
// [[vk::image_format("rgba8snorm")]] in GLSL's spelling, rgba8_snorm, for an image of these
// components; empty without one.
std::string ImageFormatOf(Context& context, List<ast::Attr> attributes, Scalar components);
bool HasConstantId(const Context& context, List<ast::Attr> attributes);
bool IsPushConstant(const Context& context, List<ast::Attr> attributes);
// [[vk::constant_id(number)]]
std::optional<std::uint32_t> ConstantIdOf(Context& context, List<ast::Attr> attributes);
// [[vk::offset(bytes)]]
std::optional<std::uint32_t> OffsetOf(Context& context, List<ast::Attr> attributes);
// [[vk::location(number)]]
std::optional<std::uint32_t> LocationOf(Context& context, List<ast::Attr> attributes);
// [[vk::builtin("BaseVertex")]] as the semantic vk::BaseVertex; empty without one.
std::string BuiltinOf(Context& context, List<ast::Attr> attributes);

// Sets the location and the semantic of an EntryParameter or an ir::Field from the attributes.
void ReadVulkan(Context& context, List<ast::Attr> attributes, auto& into) {
  if (attributes.empty()) return;
  into.location = LocationOf(context, attributes);
  if (const std::string semantic = BuiltinOf(context, attributes); !semantic.empty())
    into.semantic = semantic;
}

}  // namespace clipc::check
