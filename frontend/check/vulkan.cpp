// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/vulkan.h"

#include "frontend/check/value.h"
#include "frontend/parse/attributes.h"
#include "frontend/signature/locations.h"

namespace clipc::check {
namespace {

// The largest numbers that glslang takes: layoutLocationEnd, layoutSpecConstantIdEnd,
// layoutBindingEnd, layoutAttachmentEnd.
constexpr std::int64_t kMaxLocation = signature::kLocations - 1;
constexpr std::int64_t kMaxConstantId = 2046;
constexpr std::int64_t kMaxBinding = 0xfffe;
constexpr std::int64_t kMaxOffset = 65536;
constexpr std::int64_t kMaxAttachment = 254;

// The formats in "Format layout qualifiers" of the GLSL specification. DXC writes them without `_`.
constexpr std::string_view kFormats[] = {
    "rgba32f",     "rgba16f",    "rg32f",     "rg16f",     "r11f_g11f_b10f",
    "r32f",        "r16f",       "rgba16",    "rgb10_a2",  "rgba8",
    "rg16",        "rg8",        "r16",       "r8",        "rgba16_snorm",
    "rgba8_snorm", "rg16_snorm", "rg8_snorm", "r16_snorm", "r8_snorm",
    "rgba32i",     "rgba16i",    "rgba8i",    "rg32i",     "rg16i",
    "rg8i",        "r32i",       "r16i",      "r8i",       "rgba32ui",
    "rgba16ui",    "rgb10_a2ui", "rgba8ui",   "rg32ui",    "rg16ui",
    "rg8ui",       "r32ui",      "r16ui",     "r8ui"};

const ast::Attr* Find(const Context& context, List<ast::Attr> attributes, VulkanAttribute wanted) {
  for (const ast::Attr& attribute : context[attributes]) {
    if (VulkanAttributeOf(context[attribute.name]) == wanted) return &attribute;
  }
  return nullptr;
}

// The arguments of the attribute as numbers, from 1 to `most` of them; empty after an error.
std::vector<std::uint32_t> Numbers(Context& context, const ast::Attr& attribute, std::size_t most,
                                   std::int64_t largest, std::string_view wanted) {
  std::vector<std::uint32_t> numbers;
  const std::vector<ast::ExprId> arguments(context[attribute.arguments].begin(),
                                           context[attribute.arguments].end());
  bool fits = !arguments.empty() && arguments.size() <= most;
  for (std::size_t i = 0; fits && i < arguments.size(); ++i) {
    const auto number = ConstantInteger(context, arguments[i]);
    if (!number) return {};
    fits = *number >= 0 && *number <= largest;
    numbers.push_back(static_cast<std::uint32_t>(*number));
  }
  if (fits) return numbers;
  context.Report(attribute.span, diag::VulkanArgument, context[attribute.name], wanted);
  return {};
}

std::optional<std::uint32_t> Number(Context& context, List<ast::Attr> attributes,
                                    VulkanAttribute wanted, std::int64_t largest,
                                    std::string_view words) {
  const ast::Attr* attribute = Find(context, attributes, wanted);
  if (!attribute) return std::nullopt;
  const std::vector<std::uint32_t> numbers = Numbers(context, *attribute, 1, largest, words);
  return numbers.empty() ? std::nullopt : std::optional(numbers[0]);
}

// The only argument of the attribute, a string; empty if there is no such attribute, and after an
// error.
std::string_view Text(Context& context, List<ast::Attr> attributes, VulkanAttribute wanted,
                      std::string_view words) {
  const ast::Attr* attribute = Find(context, attributes, wanted);
  if (!attribute) return {};
  const auto arguments = context[attribute->arguments];
  const auto* text =
      arguments.size() == 1 ? context.GetIf<ast::Literal>(arguments.front()) : nullptr;
  if (text && text->kind == LiteralKind::kString)
    return context[Name{static_cast<std::uint32_t>(text->bits)}];
  context.Report(attribute->span, diag::VulkanArgument, context[attribute->name], words);
  return {};
}

}  // namespace

std::optional<Descriptor> DescriptorOf(Context& context, List<ast::Attr> attributes) {
  const ast::Attr* attribute = Find(context, attributes, VulkanAttribute::kBinding);
  if (!attribute) return std::nullopt;
  const std::vector<std::uint32_t> numbers =
      Numbers(context, *attribute, 2, kMaxBinding, "a binding and a set from 0 to 65534");
  if (numbers.empty()) return std::nullopt;
  return Descriptor{numbers[0], numbers.size() > 1 ? numbers[1] : 0};
}

bool HasConstantId(const Context& context, List<ast::Attr> attributes) {
  return Find(context, attributes, VulkanAttribute::kConstantId) != nullptr;
}

bool IsPushConstant(const Context& context, List<ast::Attr> attributes) {
  return Find(context, attributes, VulkanAttribute::kPushConstant) != nullptr;
}

std::optional<std::uint32_t> ConstantIdOf(Context& context, List<ast::Attr> attributes) {
  return Number(context, attributes, VulkanAttribute::kConstantId, kMaxConstantId,
                "a number from 0 to 2046");
}

std::optional<std::uint32_t> InputAttachmentOf(Context& context, List<ast::Attr> attributes) {
  return Number(context, attributes, VulkanAttribute::kInputAttachment, kMaxAttachment,
                "a number from 0 to 254");
}

std::optional<std::uint32_t> CounterBindingOf(Context& context, List<ast::Attr> attributes) {
  return Number(context, attributes, VulkanAttribute::kCounterBinding, kMaxBinding,
                "a binding from 0 to 65534");
}

std::optional<std::uint32_t> OffsetOf(Context& context, List<ast::Attr> attributes) {
  return Number(context, attributes, VulkanAttribute::kOffset, kMaxOffset, "bytes, at most 65536");
}

std::optional<std::uint32_t> LocationOf(Context& context, List<ast::Attr> attributes) {
  return Number(context, attributes, VulkanAttribute::kLocation, kMaxLocation,
                "a location from 0 to 4094");
}

std::optional<std::uint32_t> BlendIndexOf(Context& context, List<ast::Attr> attributes) {
  return Number(context, attributes, VulkanAttribute::kIndex, 1, "0 or 1");
}

std::string BuiltinOf(Context& context, List<ast::Attr> attributes) {
  const std::string_view name = Text(context, attributes, VulkanAttribute::kBuiltin,
                                     "the name of a built-in in quotes, such as \"BaseVertex\"");
  return name.empty() ? "" : fmt::format("vk::{}", name);
}

std::string ImageFormatOf(Context& context, List<ast::Attr> attributes, Scalar components) {
  const std::string_view words = components == Scalar::kInt ? "a format of ints, such as \"r32i\""
                                 : components == Scalar::kUint
                                     ? "a format of uints, such as \"r32ui\""
                                     : "a format of floats, such as \"rgba8\"";
  const std::string_view name = Text(context, attributes, VulkanAttribute::kImageFormat, words);
  if (name.empty()) return "";
  for (const std::string_view format : kFormats) {
    std::string plain = format == "r11f_g11f_b10f" ? "r11g11b10f" : std::string(format);
    std::erase(plain, '_');
    const Scalar kind = format.ends_with("ui")  ? Scalar::kUint
                        : format.ends_with('i') ? Scalar::kInt
                                                : Scalar::kFloat;
    if (plain == name && kind == components) return std::string(format);
  }
  const ast::Attr* attribute = Find(context, attributes, VulkanAttribute::kImageFormat);
  context.Report(attribute->span, diag::VulkanArgument, context[attribute->name], words);
  return "";
}

}  // namespace clipc::check
