// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/parse/attributes.h"

#include <algorithm>
#include <string>

#include "base/spelling.h"

namespace clipc {
namespace {

// In lower case. Sources: the attribute pages of Microsoft's HLSL reference; DXC's table of
// attributes for the stages that came later.
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

}  // namespace

AttributeMeaning MeaningOfAttribute(std::string_view name) {
  const std::string lower = ToLower(name);
  if (lower == kClipPlanesAttribute) return AttributeMeaning::kClipPlanes;
  if (std::ranges::find(kKnown, lower) != std::end(kKnown)) return AttributeMeaning::kKnown;
  // Vulkan's, in the spelling of DXC and in that of glslang; Direct3D 12's root signature.
  if (lower.starts_with("vk::") || lower == "layout" || lower == "rootsignature")
    return AttributeMeaning::kWithoutEffect;
  std::string bare = lower;
  std::erase(bare, '_');
  return EditDistance(bare, kClipPlanesAttribute, 2) <= 2 ? AttributeMeaning::kLikeClipPlanes
                                                          : AttributeMeaning::kUnknown;
}

}  // namespace clipc
