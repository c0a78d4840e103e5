// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

// The attributes of HLSL by name. The case of the letters does not matter.
namespace clipc {

inline constexpr std::string_view kClipPlanesAttribute = "clipplanes";

enum class AttributeMeaning : std::uint8_t {
  kUnknown,
  kClipPlanes,
  kLikeClipPlanes,  // unknown, and spelled nearly like `clipplanes`
  // A hint to an optimiser, or a property that only other stages have: clipc does what the
  // attribute asks for by compiling the shader.
  kKnown,
  kLaterStage,     // as kKnown, of a hull, domain or geometry shader only
  kVulkan,         // a VulkanAttribute
  kWithoutEffect,  // an attribute whose effect is lost in GLSL
};
AttributeMeaning MeaningOfAttribute(std::string_view name);

// The kind of declaration that an attribute is written at.
enum class AttributeOwner : std::uint8_t {
  kFunction,
  kParameter,
  kField,
  kVariable,  // a global variable
  kBuffer,    // a cbuffer or tbuffer
  kOther,
};

// The attributes [[vk::...]] that clipc translates. Source: "Vulkan specific attributes" in DXC's
// docs/SPIR-V.rst.
enum class VulkanAttribute : std::uint8_t {
  kLocation,  // the location of an input or output
  kIndex,     // which of the two colors of a render target that are blended an output is
  kBuiltin,   // an input or output that only Vulkan has
  kBinding,   // the number and the set of a buffer or a resource
  kPushConstant,
  kOffset,      // the offset of a field in push constants
  kConstantId,  // the number of a constant whose value is set when the pipeline is made
  kImageFormat,
  kInputAttachment,  // the number of a subpass input among the attachments
  kCounterBinding,   // the binding of the counter of a structured buffer
};
std::optional<VulkanAttribute> VulkanAttributeOf(std::string_view name);
// Whether the attribute has an effect at `owner`.
bool MayStandAt(VulkanAttribute attribute, AttributeOwner owner);

// The kinds of statement that attributes are for.
enum class StatementKind : std::uint8_t { kOther, kLoop, kIf, kSwitch };
// Whether a statement of the kind takes the attribute. True of what is not an attribute of
// statements.
bool MayStandAt(std::string_view attribute, StatementKind kind);
// Whether a loop cannot have both attributes.
bool Contradict(std::string_view one, std::string_view other);

}  // namespace clipc
