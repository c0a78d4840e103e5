// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/signature/semantics.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/spelling.h"

namespace clipc::signature {
namespace {

using Use = SystemValue::Use;
using Form = SystemValue::Form;

// The meanings on the two sides of a stage.
struct Sides {
  SystemValue input, output;
};

constexpr SystemValue kPlain{};
constexpr SystemValue kRefused{Use::kRefused, Builtin::kNone, 0, 0};
constexpr SystemValue kMade{Use::kMade, Builtin::kNone, 0, 0};
constexpr SystemValue kLost{Use::kLost, Builtin::kNone, 0, 0};
constexpr SystemValue kTarget{Use::kTarget, Builtin::kNone, 0, 0};
constexpr SystemValue Is(Builtin builtin, int major = 4, int minor = 0) {
  return {Use::kBuiltin, builtin, major, minor};
}
constexpr Sides kNowhere{kRefused, kRefused};
constexpr Sides kOnlyMade{kMade, kRefused};
constexpr Sides kAnywhere{kPlain, kPlain};
constexpr Sides kPointSizes{Is(Builtin::kPointSizeInput), Is(Builtin::kPointSize)};

// The meanings at the control points of a hull and of a domain shader, and among the constants of
// the patch, which the one writes and the other reads.
struct Patches {
  Sides hull = kNowhere, domain = kNowhere, constants = kNowhere;
};
constexpr Patches kNoPatches;
constexpr Patches kPatchData{kAnywhere, kAnywhere, kAnywhere};
constexpr Patches kPointData{kAnywhere, kAnywhere, kNowhere};
// A value of control points that is the rasteriser's after a domain shader.
constexpr Patches AtPoints(Builtin input, Builtin output) {
  return {{Is(input), Is(output)}, {Is(input), Is(output)}, kAnywhere};
}
constexpr Patches OfConstants(SystemValue input, SystemValue output) {
  return {kNowhere, kNowhere, {input, output}};
}

constexpr Patches kSizesAtPoints{kPointSizes, kPointSizes, kNowhere};

struct Semantic {
  std::string_view name;
  Sides vertex, pixel, geometry = kNowhere;
  Patches patches = kNoPatches;
  Sides compute = kNowhere;
  bool is_old = false;  // Direct3D 9's name of an output, which is data from profile 4.0 on

  const SystemValue& Of(Stage stage, Direction direction) const {
    const Sides* const columns[] = {&vertex,   &pixel,        &compute,
                                    &geometry, &patches.hull, &patches.domain};
    static_assert(std::size(columns) == kStageCount);
    const bool is_constant = direction == Direction::kPatchConstant;
    const Sides& sides =
        is_constant ? patches.constants : *columns[static_cast<std::size_t>(stage)];
    return IsInput(direction, stage) ? sides.input : sides.output;
  }
};

// The system values, as an input and as an output of each stage. A position or clip distance that
// the input assembler reads is data like any other (DXC: "Arb" for the vertex input).
constexpr Semantic kSemantics[] = {
    {"SV_Position",
     {kPlain, Is(Builtin::kPosition, 0)},
     {Is(Builtin::kPixelPosition), kRefused},
     {Is(Builtin::kPositionInput), Is(Builtin::kPosition)},
     AtPoints(Builtin::kPositionInput, Builtin::kPosition)},
    {"SV_ClipDistance",
     {kPlain, Is(Builtin::kClipDistance)},
     {Is(Builtin::kClipDistanceInput), kRefused},
     {Is(Builtin::kClipDistanceInput), Is(Builtin::kClipDistance)},
     AtPoints(Builtin::kClipDistanceInput, Builtin::kClipDistance)},
    {"SV_CullDistance",
     {kPlain, Is(Builtin::kCullDistance)},
     {Is(Builtin::kCullDistanceInput), kRefused},
     {Is(Builtin::kCullDistanceInput), Is(Builtin::kCullDistance)},
     AtPoints(Builtin::kCullDistanceInput, Builtin::kCullDistance)},
    {"SV_VertexID", {Is(Builtin::kVertexId), kPlain}, kOnlyMade, kAnywhere, kPointData},
    {"SV_InstanceID",
     {Is(Builtin::kInstanceId), kPlain},
     {kPlain, kRefused},
     kAnywhere,
     kPointData},
    {"SV_StartVertexLocation", {Is(Builtin::kBaseVertex, 6, 8), kRefused}, kNowhere},
    {"SV_StartInstanceLocation", {Is(Builtin::kBaseInstance, 6, 8), kRefused}, kNowhere},
    {"SV_ViewID",
     {Is(Builtin::kViewId, 6, 1), kPlain},
     {Is(Builtin::kViewId, 6, 1), kRefused},
     {Is(Builtin::kViewId, 6, 1), kPlain},
     {{Is(Builtin::kViewId, 6, 1), kPlain}, kAnywhere, {Is(Builtin::kViewId, 6, 1), kPlain}}},
    {"SV_VulkanVertexID", {Is(Builtin::kVertexIndex), kRefused}, kNowhere},  // Slang's name
    {"SV_VulkanInstanceID", {Is(Builtin::kInstanceIndex), kRefused}, kNowhere},
    {"SV_ShadingRate",
     {kPlain, Is(Builtin::kShadingRate, 6, 4)},
     {Is(Builtin::kShadingRateInput, 6, 4), kRefused}},
    {"SV_RenderTargetArrayIndex",
     {kPlain, Is(Builtin::kLayer)},
     {Is(Builtin::kLayerInput), kRefused},
     {kPlain, Is(Builtin::kLayer)},
     {kAnywhere, {kPlain, Is(Builtin::kLayer)}, kAnywhere}},
    {"SV_ViewportArrayIndex",
     {kPlain, Is(Builtin::kViewportIndex)},
     {Is(Builtin::kViewportInput), kRefused},
     {kPlain, Is(Builtin::kViewportIndex)},
     {kAnywhere, {kPlain, Is(Builtin::kViewportIndex)}, kAnywhere}},
    {"SV_DispatchThreadID",
     kNowhere,
     kOnlyMade,
     kNowhere,
     kNoPatches,
     {Is(Builtin::kThreadId), kRefused}},
    {"SV_GroupID", kNowhere, kOnlyMade, kNowhere, kNoPatches, {Is(Builtin::kGroupId), kRefused}},
    {"SV_GroupThreadID",
     kNowhere,
     kOnlyMade,
     kNowhere,
     kNoPatches,
     {Is(Builtin::kGroupThreadId), kRefused}},
    {"SV_GroupIndex",
     kNowhere,
     kOnlyMade,
     kNowhere,
     kNoPatches,
     {Is(Builtin::kGroupIndex), kRefused}},
    {"SV_PrimitiveID",
     {kRefused, kPlain},
     {Is(Builtin::kPrimitiveId), kRefused},
     {Is(Builtin::kPrimitiveId), Is(Builtin::kPrimitiveIdOutput)},
     {{Is(Builtin::kPrimitiveId), kPlain}, kAnywhere, {Is(Builtin::kPrimitiveId), kPlain}}},
    {"SV_GSInstanceID", kNowhere, kOnlyMade, {Is(Builtin::kEmitterId, 5), kRefused}},
    {"SV_OutputControlPointID",
     kNowhere,
     kOnlyMade,
     kNowhere,
     {{Is(Builtin::kControlPointId, 5), kRefused}, kNowhere, kNowhere}},
    {"SV_DomainLocation", kNowhere, kOnlyMade, kNowhere,
     OfConstants(Is(Builtin::kDomainLocation, 5), kRefused)},
    {"SV_TessFactor", kNowhere, kOnlyMade, kNowhere,
     OfConstants(Is(Builtin::kTessFactorInput, 5), Is(Builtin::kTessFactor, 5))},
    {"SV_InsideTessFactor", kNowhere, kOnlyMade, kNowhere,
     OfConstants(Is(Builtin::kInsideFactorInput, 5), Is(Builtin::kInsideFactor, 5))},
    {"SV_IsFrontFace", kNowhere, {Is(Builtin::kFrontFacing), kRefused}, {kRefused, kPlain}},
    {"SV_SampleIndex", kNowhere, {Is(Builtin::kSampleIndex, 4, 1), kRefused}},
    {"SV_Coverage", kNowhere, {Is(Builtin::kCoverageInput, 5), Is(Builtin::kCoverage, 4, 1)}},
    {"SV_InnerCoverage", kNowhere, {Is(Builtin::kFullyCovered, 5), kRefused}},
    {"SV_Barycentrics", kNowhere, {Is(Builtin::kBarycentrics, 6, 1), kRefused}},
    {"SV_Target", kNowhere, {kRefused, kTarget}},
    {"SV_Depth", kNowhere, {kRefused, Is(Builtin::kDepth)}},
    {"SV_DepthGreaterEqual", kNowhere, {kRefused, Is(Builtin::kDepthGreaterEqual, 5)}},
    {"SV_DepthLessEqual", kNowhere, {kRefused, Is(Builtin::kDepthLessEqual, 5)}},
    {"SV_StencilRef", kNowhere, {kRefused, Is(Builtin::kStencilRef, 5)}},
    // Direct3D 9's names. Those of a pixel shader's inputs and outputs mean the same under later
    // profiles.
    {"VPOS",
     kAnywhere,
     {{Use::kBuiltin, Builtin::kPixelPosition, 3, 0, Form::kCorner}, kRefused},
     kAnywhere,
     kPatchData},
    {"VFACE",
     kAnywhere,
     {{Use::kBuiltin, Builtin::kFrontFacing, 3, 0, Form::kSign}, kRefused},
     kAnywhere,
     kPatchData},
    {"COLOR", kAnywhere, {kPlain, kTarget}, kAnywhere, kPatchData},
    {"DEPTH", kAnywhere, {kPlain, Is(Builtin::kDepth, 0)}, kAnywhere, kPatchData},
    {"POSITION",
     {kPlain, Is(Builtin::kPosition, 0)},
     {kLost, kRefused},
     {kPlain, Is(Builtin::kPosition, 0)},
     {kAnywhere, {kPlain, Is(Builtin::kPosition, 0)}, kAnywhere},
     kNowhere,
     true},
    {"PSIZE",
     {kPlain, Is(Builtin::kPointSize, 0)},
     {kLost, kRefused},
     kAnywhere,
     kPatchData,
     kNowhere,
     true},
    // SV_PointSize is Slang's and SDL's name for Direct3D 9's PSIZE.
    {"SV_PointSize",
     {kRefused, Is(Builtin::kPointSize, 0)},
     kOnlyMade,
     kPointSizes,
     kSizesAtPoints},
    // vk::PointSize is written [[vk::builtin("PointSize")]].
    {"vk::PointSize",
     {kRefused, Is(Builtin::kPointSize, 0)},
     kOnlyMade,
     kPointSizes,
     kSizesAtPoints},
    {"vk::BaseVertex", {Is(Builtin::kBaseVertex, 0), kRefused}, kNowhere},
    {"vk::BaseInstance", {Is(Builtin::kBaseInstance, 0), kRefused}, kNowhere},
    {"vk::DrawIndex", {Is(Builtin::kDrawIndex, 0), kRefused}, kNowhere},
};
// Any other system value. A struct may carry it to a pixel shader that does not read it.
constexpr Semantic kUnknown = {{}, kNowhere, {kMade, kPlain}};

// The meaning of a name that is not a system value's: of data from stage to stage.
SystemValue OtherName(Stage stage, Direction direction) {
  if (InfoOf(stage).runs_in_groups) return kRefused;
  return direction != Direction::kOutput || InfoOf(stage).has_stage_after ? kPlain : kRefused;
}

}  // namespace

SystemValue LookUpSemantic(std::string_view name, std::uint32_t index, Stage stage,
                           Direction direction, bool is_old, PositionName position) {
  for (const Semantic& row : kSemantics) {
    if (row.name.size() != name.size() || !EqualIgnoringCase(row.name, name)) continue;
    const SystemValue& value = row.Of(stage, direction);
    const bool counts =
        !row.is_old ||
        (index == 0 &&
         (is_old || (value.builtin == Builtin::kPosition && position == PositionName::kBoth)));
    return counts ? value : OtherName(stage, direction);
  }
  const bool is_system =
      EqualIgnoringCase(name.substr(0, 3), "sv_") || EqualIgnoringCase(name.substr(0, 4), "vk::");
  return is_system ? kUnknown.Of(stage, direction) : OtherName(stage, direction);
}

bool IsNumberOfThread(Builtin builtin) {
  return InfoOf(builtin).components == 3 && InfoOf(builtin).scalar == Scalar::kUint;
}

std::string CompiledBy(const StageInfo& stage, const Profile& profile) {
  const std::string& name = profile.name;
  const std::string same =
      fmt::format("{}{}", stage.prefix, name.substr(std::min(name.find('_'), name.size())));
  return fmt::format("; `-T {}` compiles a {} shader",
                     ir::ParseProfile(same) ? same : fmt::format("{}_5_0", stage.prefix),
                     stage.name);
}

std::string AdviceForObject(std::string_view type, Stage stage, const Profile& profile) {
  constexpr std::pair<std::string_view, std::string_view> kStagesWith[] = {{"PointStream", "gs"},
                                                                           {"LineStream", "gs"},
                                                                           {"TriangleStream", "gs"},
                                                                           {"InputPatch", "hs"},
                                                                           {"OutputPatch", "ds"}};
  for (const auto& [object, prefix] : kStagesWith) {
    const auto other = StageOf(prefix);
    if (type.substr(0, type.find('<')) == object && other && *other != stage)
      return CompiledBy(InfoOf(*other), profile);
  }
  return {};
}

std::string_view NearSystemValue(std::string_view name, Stage stage, Direction direction) {
  std::vector<std::string_view> names;
  for (const Semantic& row : kSemantics) {
    const Use use = row.Of(stage, direction).use;
    if (!row.is_old && (use == Use::kBuiltin || use == Use::kTarget || use == Use::kMade))
      names.push_back(row.name);
  }
  const std::vector<std::string_view> near = NearNames(name, names);
  return near.empty() ? std::string_view() : near.front();
}

SemanticName SplitSemantic(std::string_view written) {
  std::size_t end = written.size();
  while (end > 0 && written[end - 1] >= '0' && written[end - 1] <= '9' && written.size() - end < 9)
    --end;
  std::uint32_t index = 0;
  for (char c : written.substr(end)) index = index * 10 + static_cast<std::uint32_t>(c - '0');
  return {std::string(written.substr(0, end)), index, end < written.size()};
}

bool LacksInput(const Profile& profile, const SemanticName& semantic) {
  if (profile.major != 2) return false;
  const std::uint32_t count = EqualIgnoringCase(semantic.name, "COLOR")      ? 2
                              : EqualIgnoringCase(semantic.name, "TEXCOORD") ? 8
                                                                             : 0;
  return semantic.index >= count;
}

std::uint32_t TargetsOf(const Profile& profile) {
  if (profile.level9 == Level9::k9_0 || profile.level9 == Level9::k9_1) return 1;
  return profile.IsDirect3D9() || profile.level9 == Level9::k9_3 ? 4 : 8;
}

const IoVar* FindPlainPosition(const Program& program) {
  const auto found = std::ranges::find_if(program.outputs, [](const IoVar& output) {
    return output.builtin == Builtin::kNone && output.index == 0 &&
           EqualIgnoringCase(output.semantic, "POSITION");
  });
  return found == program.outputs.end() ? nullptr : &*found;
}

}  // namespace clipc::signature
