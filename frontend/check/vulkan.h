// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// The attributes [[vk::...]], as "Vulkan specific attributes" in DXC's docs/SPIR-V.rst has them.
namespace clipc::check {

// The descriptor that [[vk::binding(number, set)]] gives; the set may be left out. Returns nullopt
// if there is no such attribute, and after an error, which was reported.
std::optional<Descriptor> DescriptorOf(Context& context, List<ast::Attr> attributes);
// The format that [[vk::image_format("rgba8snorm")]] gives, in GLSL's spelling, rgba8_snorm, for an
// image whose components are `components`; empty if there is no such attribute.
std::string ImageFormatOf(Context& context, List<ast::Attr> attributes, Scalar components);
bool HasConstantId(const Context& context, List<ast::Attr> attributes);
bool IsPushConstant(const Context& context, List<ast::Attr> attributes);
// The number that [[vk::constant_id(number)]] gives; nullopt without one, and after an error.
std::optional<std::uint32_t> ConstantIdOf(Context& context, List<ast::Attr> attributes);
// The number that [[vk::input_attachment_index(number)]] gives; nullopt as above.
std::optional<std::uint32_t> InputAttachmentOf(Context& context, List<ast::Attr> attributes);
// The number that [[vk::counter_binding(number)]] gives; nullopt as above.
std::optional<std::uint32_t> CounterBindingOf(Context& context, List<ast::Attr> attributes);
// The offset that [[vk::offset(bytes)]] gives; nullopt without one, and after an error.
std::optional<std::uint32_t> OffsetOf(Context& context, List<ast::Attr> attributes);
// The number that [[vk::location(number)]] gives; nullopt without one, and after an error.
std::optional<std::uint32_t> LocationOf(Context& context, List<ast::Attr> attributes);
// The number that [[vk::index(number)]] gives, 0 or 1; nullopt as above.
std::optional<std::uint32_t> BlendIndexOf(Context& context, List<ast::Attr> attributes);
// The semantic for [[vk::builtin("BaseVertex")]], vk::BaseVertex; empty if there is no such
// attribute.
std::string BuiltinOf(Context& context, List<ast::Attr> attributes);

// Sets the location, the blend index and the semantic of an EntryParameter or an ir::Field from the
// attributes.
void ReadVulkan(Context& context, List<ast::Attr> attributes, auto& into) {
  if (attributes.empty()) return;
  into.location = LocationOf(context, attributes);
  into.blend_index = BlendIndexOf(context, attributes);
  if (const std::string semantic = BuiltinOf(context, attributes); !semantic.empty())
    into.semantic = semantic;
}

}  // namespace clipc::check
