// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/parse/attributes.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "base/spelling.h"

namespace clipc {
namespace {

// The known attributes of declarations, in lower case. Sources: the attribute pages of Microsoft's
// HLSL reference; DXC's table of attributes for the stages that came later.
constexpr std::string_view kOfLaterStages[] = {
    "domain",         "instance",     "maxtessfactor",     "maxvertexcount", "outputcontrolpoints",
    "outputtopology", "partitioning", "patchconstantfunc",
};
constexpr std::string_view kKnown[] = {
    // of functions
    "earlydepthstencil",
    "experimental",
    "noinline",
    "numthreads",
    "rootsignature",  // how a Direct3D 12 application binds: GLSL has layouts
    "shader",
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

// The attributes of statements, and what each is for. Sources: as of kKnown, and DXC's
// attributes.hlsl, with what fxc says.
struct StatementAttribute {
  std::string_view name;
  StatementKind kind;
  bool is_for_switch = false;
};
constexpr StatementAttribute kOfStatements[] = {
    {"allow_uav_condition", StatementKind::kLoop},
    {"branch", StatementKind::kIf, true},
    {"call", StatementKind::kSwitch},
    {"fastopt", StatementKind::kLoop},
    {"flatten", StatementKind::kIf, true},
    {"forcecase", StatementKind::kSwitch},
    {"loop", StatementKind::kLoop},
    {"unroll", StatementKind::kLoop},
};

// The names of the attributes in the order of VulkanAttribute.
constexpr std::string_view kVulkanNames[] = {
    "vk::location",       "vk::index",         "vk::builtin",
    "vk::binding",        "vk::push_constant", "vk::offset",
    "vk::constant_id",    "vk::image_format",  "vk::input_attachment_index",
    "vk::counter_binding"};

}  // namespace

std::optional<VulkanAttribute> VulkanAttributeOf(std::string_view name) {
  if (name.find(':') == name.npos) return std::nullopt;
  const auto* found = std::ranges::find_if(
      kVulkanNames, [&](std::string_view known) { return EqualIgnoringCase(known, name); });
  if (found == std::end(kVulkanNames)) return std::nullopt;
  return static_cast<VulkanAttribute>(found - std::begin(kVulkanNames));
}

bool MayStandAt(VulkanAttribute attribute, AttributeOwner owner) {
  using enum AttributeOwner;
  switch (attribute) {
    case VulkanAttribute::kLocation:
    case VulkanAttribute::kIndex:
    case VulkanAttribute::kBuiltin:
      return owner == kFunction || owner == kParameter || owner == kField;
    case VulkanAttribute::kBinding:
    case VulkanAttribute::kPushConstant: return owner == kVariable || owner == kBuffer;
    case VulkanAttribute::kOffset: return owner == kField;
    case VulkanAttribute::kConstantId:
    case VulkanAttribute::kImageFormat:
    case VulkanAttribute::kInputAttachment:
    case VulkanAttribute::kCounterBinding: return owner == kVariable;
  }
  return false;
}

bool MayStandAt(std::string_view attribute, StatementKind kind) {
  const std::string lower = ToLower(attribute);
  const auto* found = std::ranges::find(kOfStatements, lower, &StatementAttribute::name);
  if (found == std::end(kOfStatements)) return true;
  return kind == found->kind || (kind == StatementKind::kSwitch && found->is_for_switch);
}

bool Contradict(std::string_view one, std::string_view other) {
  const auto is = [&](std::string_view name, std::string_view text) {
    return EqualIgnoringCase(name, text);
  };
  const auto rolls = [&](std::string_view name) { return is(name, "loop") || is(name, "fastopt"); };
  return (rolls(one) && is(other, "unroll")) || (is(one, "unroll") && rolls(other));
}

AttributeMeaning MeaningOfAttribute(std::string_view name) {
  if (VulkanAttributeOf(name)) return AttributeMeaning::kVulkan;
  const std::string lower = ToLower(name);
  if (lower == kClipPlanesAttribute) return AttributeMeaning::kClipPlanes;
  if (std::ranges::find(kOfLaterStages, lower) != std::end(kOfLaterStages))
    return AttributeMeaning::kLaterStage;
  if (std::ranges::find(kKnown, lower) != std::end(kKnown) ||
      std::ranges::find(kOfStatements, lower, &StatementAttribute::name) != std::end(kOfStatements))
    return AttributeMeaning::kKnown;
  // The rest are Vulkan's other attributes, as DXC and as glslang spells them.
  if (lower.starts_with("vk::") || lower == "layout") return AttributeMeaning::kWithoutEffect;
  std::string bare = lower;
  std::erase(bare, '_');
  return EditDistance(bare, kClipPlanesAttribute, 2) <= 2 ? AttributeMeaning::kLikeClipPlanes
                                                          : AttributeMeaning::kUnknown;
}

}  // namespace clipc
