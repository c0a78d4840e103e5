// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/parse/attributes.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "base/spelling.h"

namespace clipc {
namespace {

// The known attributes, in lower case. Sources: the attribute pages of Microsoft's HLSL reference;
// DXC's table of attributes for the stages that came later.
constexpr std::string_view kKnown[] = {
    // of statements
    "allow_uav_condition",
    "branch",
    "call",
    "fastopt",
    "flatten",
    "forcecase",
    "loop",
    "unroll",
    // of functions
    "domain",
    "earlydepthstencil",
    "experimental",
    "instance",
    "maxtessfactor",
    "maxvertexcount",
    "noinline",
    "numthreads",
    "outputcontrolpoints",
    "outputtopology",
    "partitioning",
    "patchconstantfunc",
    "shader",
    "waveopsincludehelperlanes",
    "wavesensitive",
    "wavesize",
    // of ray tracing and work graphs
    "allowsparsenodes",
    "maxrecords",
    "maxrecordssharedwith",
    "nodearraysize",
    "nodedispatchgrid",
    "nodeid",
    "nodeisprogramentry",
    "nodelaunch",
    "nodelocalrootargumentstableindex",
    "nodemaxdispatchgrid",
    "nodemaxinputrecordspergraphentryrecord",
    "nodemaxrecursiondepth",
    "nodeshareinputof",
    "nodetrackrwinputsharing",
    "raypayload",
    "unboundedsparsenodes",
};

// The names of the attributes in the order of VulkanAttribute.
constexpr std::string_view kVulkanNames[] = {"vk::location",      "vk::builtin", "vk::binding",
                                             "vk::push_constant", "vk::offset",  "vk::constant_id",
                                             "vk::image_format"};

}  // namespace

std::optional<VulkanAttribute> VulkanAttributeOf(std::string_view name) {
  if (name.find(':') == name.npos) return std::nullopt;
  const auto* found = std::ranges::find(kVulkanNames, ToLower(name));
  if (found == std::end(kVulkanNames)) return std::nullopt;
  return static_cast<VulkanAttribute>(found - std::begin(kVulkanNames));
}

bool MayStandAt(VulkanAttribute attribute, AttributeOwner owner) {
  using enum AttributeOwner;
  switch (attribute) {
    case VulkanAttribute::kLocation:
    case VulkanAttribute::kBuiltin:
      return owner == kFunction || owner == kParameter || owner == kField;
    case VulkanAttribute::kBinding:
    case VulkanAttribute::kPushConstant: return owner == kVariable || owner == kBuffer;
    case VulkanAttribute::kOffset: return owner == kField;
    case VulkanAttribute::kConstantId:
    case VulkanAttribute::kImageFormat: return owner == kVariable;
  }
  return false;
}

AttributeMeaning MeaningOfAttribute(std::string_view name) {
  const std::string lower = ToLower(name);
  if (lower == kClipPlanesAttribute) return AttributeMeaning::kClipPlanes;
  if (std::ranges::find(kKnown, lower) != std::end(kKnown)) return AttributeMeaning::kKnown;
  if (VulkanAttributeOf(name)) return AttributeMeaning::kVulkan;
  // The rest are Vulkan's other attributes, as DXC and as glslang spells them, and Direct3D 12's
  // root signature.
  if (lower.starts_with("vk::") || lower == "layout" || lower == "rootsignature")
    return AttributeMeaning::kWithoutEffect;
  std::string bare = lower;
  std::erase(bare, '_');
  return EditDistance(bare, kClipPlanesAttribute, 2) <= 2 ? AttributeMeaning::kLikeClipPlanes
                                                          : AttributeMeaning::kUnknown;
}

}  // namespace clipc
