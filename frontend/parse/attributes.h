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
  // A hint to an optimiser, or a property that only other stages have: clipc does what it asks for
  // by compiling the shader.
  kKnown,
  kVulkan,         // a VulkanAttribute
  kWithoutEffect,  // what it asks for is lost in GLSL
};
AttributeMeaning MeaningOfAttribute(std::string_view name);

// What an attribute is written at.
enum class AttributeOwner : std::uint8_t {
  kFunction,
  kParameter,
  kField,
  kVariable,  // global
  kBuffer,    // cbuffer or tbuffer
  kOther,
};

// The attributes [[vk::...]] that clipc translates. Source: "Vulkan specific attributes" in DXC's
// docs/SPIR-V.rst.
enum class VulkanAttribute : std::uint8_t {
  kLocation,  // of an input or output
  kBuiltin,   // an input or output that only Vulkan has
  kBinding,   // of a buffer or a resource: number and set
  kPushConstant,
  kOffset,      // of a field in push constants
  kConstantId,  // of a constant that is given a value when the pipeline is made
  kImageFormat,
};
std::optional<VulkanAttribute> VulkanAttributeOf(std::string_view name);
// Whether the attribute has an effect there.
bool MayStandAt(VulkanAttribute attribute, AttributeOwner owner);

}  // namespace clipc
