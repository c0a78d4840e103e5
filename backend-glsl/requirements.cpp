// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/requirements.h"

#include <algorithm>
#include <iterator>

#include "ir/access.h"
#include "ir/evaluate.h"

namespace clipc::glsl {

using ir::Builtin;
using ir::ObjectKind;
using ir::ObjectOp;
using ir::Scalar;

namespace {

template <typename Part>
struct Row {
  Part part;
  Requirement requirement;
};

constexpr Row<Builtin> kBuiltins[] = {
    {Builtin::kVertexId, {Feature::kVertexId, &diag::TargetVertexId}},
    {Builtin::kVertexIndex, {Feature::kVertexId, &diag::TargetVertexId}},
    {Builtin::kInstanceId, {Feature::kInstanceId, &diag::TargetInstanceId}},
    {Builtin::kInstanceIndex, {Feature::kDrawParameters, nullptr, &diag::TargetDrawParameter}},
    {Builtin::kBaseVertex, {Feature::kDrawParameters, nullptr, &diag::TargetDrawParameter}},
    {Builtin::kBaseInstance, {Feature::kDrawParameters, nullptr, &diag::TargetDrawParameter}},
    {Builtin::kDrawIndex, {Feature::kDrawParameters, nullptr, &diag::TargetDrawParameter}},
    {Builtin::kViewId, {Feature::kViewIndex, &diag::TargetViewId}},
    {Builtin::kClipDistance, {Feature::kClipDistance, &diag::TargetClipDistance}},
    {Builtin::kCullDistance, {Feature::kCullDistance, &diag::TargetCullDistance}},
    {Builtin::kClipVertex, {Feature::kClipVertex, &diag::TargetClipVertex}},
    {Builtin::kShadingRate, {Feature::kShadingRate, &diag::TargetShadingRate}},
    {Builtin::kLayer, {Feature::kLayerAndViewport, nullptr, &diag::TargetLayer}},
    {Builtin::kViewportIndex, {Feature::kLayerAndViewport, nullptr, &diag::TargetLayer}},
    {Builtin::kSampleIndex, {Feature::kSampleVariables, nullptr, &diag::TargetPixelValue}},
    {Builtin::kCoverageInput, {Feature::kSampleVariables, nullptr, &diag::TargetPixelValue}},
    {Builtin::kPrimitiveId, {Feature::kPrimitiveIdInput, nullptr, &diag::TargetPixelValue}},
    {Builtin::kLayerInput, {Feature::kLayerInput, nullptr, &diag::TargetPixelValue}},
    {Builtin::kViewportInput, {Feature::kViewportInput, nullptr, &diag::TargetPixelValue}},
    {Builtin::kBarycentrics, {Feature::kBarycentrics, nullptr, &diag::TargetPixelValue}},
    {Builtin::kBarycentricsNoPerspective,
     {Feature::kBarycentrics, nullptr, &diag::TargetPixelValue}},
    {Builtin::kFullyCovered, {Feature::kFullyCovered, nullptr, &diag::TargetPixelValue}},
    {Builtin::kSampleCount, {Feature::kSampleCount, nullptr, &diag::TargetPixelValue}},
    {Builtin::kHelperLane, {Feature::kHelperInvocation, nullptr, &diag::TargetPixelValue}},
    {Builtin::kLaneCount, {Feature::kSubgroups, nullptr, &diag::TargetWave}},
    {Builtin::kLaneIndex, {Feature::kSubgroups, nullptr, &diag::TargetWave}},
    {Builtin::kShadingRateInput, {Feature::kShadingRate, nullptr, &diag::TargetPixelValue}},
    {Builtin::kClipDistanceInput, {Feature::kClipDistance, nullptr, &diag::TargetPixelValue}},
    {Builtin::kCullDistanceInput, {Feature::kCullDistance, nullptr, &diag::TargetPixelValue}},
    {Builtin::kDepth, {Feature::kDepthOutput, nullptr, &diag::TargetPixelValue}},
    // The promise that the depth is on one side only is one that a target may do without.
    {Builtin::kDepthGreaterEqual, {Feature::kDepthOutput, nullptr, &diag::TargetPixelValue}},
    {Builtin::kDepthLessEqual, {Feature::kDepthOutput, nullptr, &diag::TargetPixelValue}},
    {Builtin::kCoverage, {Feature::kSampleVariables, nullptr, &diag::TargetPixelValue}},
    {Builtin::kStencilRef, {Feature::kStencilOutput, nullptr, &diag::TargetPixelValue}},
};

// In a stage that emits vertices, where some need nothing but the stage itself.
constexpr Row<Builtin> kBuiltinsOfEmission[] = {
    {Builtin::kPrimitiveId, {Feature::kGeometryShaders}},
    {Builtin::kLayer, {Feature::kGeometryShaders}},
    {Builtin::kViewportIndex, {Feature::kViewportOfVertex, nullptr, &diag::TargetEmission}},
    {Builtin::kEmitterId, {Feature::kEmitters, nullptr, &diag::TargetEmission}},
};

constexpr Requirement kImage = {Feature::kImages, nullptr, &diag::TargetImage};
constexpr Requirement kStorageBuffer = {Feature::kStorageBuffers, nullptr,
                                        &diag::TargetStorageBuffer};
constexpr Row<ObjectKind> kObjects[] = {
    {ObjectKind::kTexture1D, {Feature::kTexture1D, nullptr, &diag::TargetTexture1D}},
    {ObjectKind::kSampler1D, {Feature::kTexture1D, nullptr, &diag::TargetTexture1D}},
    {ObjectKind::kSampler2DShadow, {Feature::kShadowSamplers, nullptr, &diag::TargetShadowSampler}},
    // A Texture1DArray needs what a Texture1D needs, too.
    {ObjectKind::kTexture1DArray, {Feature::kTextureArrays, nullptr, &diag::TargetTextureArray}},
    {ObjectKind::kTexture3D, {Feature::kTexture3D, nullptr, &diag::TargetTexture3D}},
    {ObjectKind::kSampler3D, {Feature::kTexture3D, nullptr, &diag::TargetTexture3D}},
    {ObjectKind::kTexture2DArray, {Feature::kTextureArrays, nullptr, &diag::TargetTextureArray}},
    {ObjectKind::kTextureCubeArray, {Feature::kCubeArrays, nullptr, &diag::TargetCubeArray}},
    {ObjectKind::kTexture2DMS, {Feature::kMultisample, nullptr, &diag::TargetMultisample}},
    {ObjectKind::kTexture2DMSArray,
     {Feature::kMultisampleArrays, nullptr, &diag::TargetMultisample}},
    {ObjectKind::kSubpassInputMS, {Feature::kMultisample, nullptr, &diag::TargetMultisample}},
    {ObjectKind::kBuffer, {Feature::kTextureBuffers, nullptr, &diag::TargetTextureBuffer}},
};

constexpr Row<ObjectOp> kObjectOps[] = {
    {ObjectOp::kSampleGrad, {Feature::kTextureFunctions, &diag::TargetSampleGradient}},
    {ObjectOp::kSampleCmp, {Feature::kTextureFunctions, &diag::TargetSampleCompare}},
    {ObjectOp::kLevelOfDetail,
     {Feature::kLevelQueries, nullptr, &diag::TargetTextureQuery, "level of detail"}},
    {ObjectOp::kLevelOfDetailUnclamped,
     {Feature::kLevelQueries, nullptr, &diag::TargetTextureQuery, "level of detail"}},
    {ObjectOp::kSampleCmpLevelZero, {Feature::kTextureFunctions, &diag::TargetSampleCompare}},
    {ObjectOp::kSampleCmpLevel, {Feature::kTextureFunctions, &diag::TargetSampleCompare}},
    {ObjectOp::kSampleCmpBias, {Feature::kTextureFunctions, &diag::TargetSampleCompare}},
    {ObjectOp::kSampleCmpGrad, {Feature::kTextureFunctions, &diag::TargetSampleCompare}},
    {ObjectOp::kGather, {Feature::kGather, nullptr, &diag::TargetGather, "`Gather`"}},
    {ObjectOp::kGatherGreen,
     {Feature::kGatherComponents, nullptr, &diag::TargetGather, "`GatherGreen`"}},
    {ObjectOp::kGatherBlue,
     {Feature::kGatherComponents, nullptr, &diag::TargetGather, "`GatherBlue`"}},
    {ObjectOp::kGatherAlpha,
     {Feature::kGatherComponents, nullptr, &diag::TargetGather, "`GatherAlpha`"}},
    {ObjectOp::kGatherCmp,
     {Feature::kGatherComponents, nullptr, &diag::TargetGather, "`GatherCmp`"}},
    {ObjectOp::kSubpassLoad, {Feature::kTextureFunctions, &diag::TargetTextureLoad}},
    {ObjectOp::kTextureLoad, {Feature::kTextureFunctions, &diag::TargetTextureLoad}},
    {ObjectOp::kTextureSize,
     {Feature::kTextureFunctions, nullptr, &diag::TargetTextureQuery, "size"}},
    {ObjectOp::kBufferSize,
     {Feature::kTextureFunctions, nullptr, &diag::TargetTextureQuery, "size"}},
    {ObjectOp::kTextureLevels,
     {Feature::kTextureLevels, nullptr, &diag::TargetTextureQuery, "number of levels"}},
    {ObjectOp::kTextureSamples,
     {Feature::kTextureSamples, nullptr, &diag::TargetTextureQuery, "number of samples"}},
};

constexpr Requirement kDouble = {Feature::kDoubles, &diag::TargetDouble};
constexpr Requirement kInt64 = {Feature::kInt64, &diag::TargetInt64};

template <typename Part, std::size_t N>
const Requirement* Find(const Row<Part> (&rows)[N], Part part) {
  const auto* found = std::ranges::find(rows, part, &Row<Part>::part);
  return found == std::end(rows) ? nullptr : &found->requirement;
}

}  // namespace

bool NeedsFramebufferHeight(const ir::Program& program, const Target& target,
                            const ir::IoVar& input) {
  return input.builtin == Builtin::kPixelPosition && !target.HasUpperLeftOrigin() &&
         !target.Has(Feature::kUpperLeftOrigin) &&
         (ComponentsRead(program)[input.var.index] & 0b10) != 0;
}

bool HasVaryingOffset(const ir::Program& program, const ir::ObjectCall& call) {
  if (!IsGather(call.op)) return false;
  const auto offsets = program.expr_lists[OperandsOf(call, ir::OperandKind::kOffset)];
  return !std::ranges::all_of(
      offsets, [&](ir::ExprId offset) { return ConstantBits(program, offset).has_value(); });
}

bool HasShadowLevels(ObjectKind kind) {
  return kind == ObjectKind::kTexture1D || kind == ObjectKind::kTexture2D ||
         kind == ObjectKind::kTexture1DArray;
}

bool HasComparison(ObjectOp op, ObjectKind kind, const StageInfo& stage) {
  const bool is_cube_array = kind == ObjectKind::kTextureCubeArray;
  switch (op) {
    case ObjectOp::kSampleCmpLevelZero: return !is_cube_array || !stage.has_neighbours;
    case ObjectOp::kSampleCmpGrad: return !is_cube_array;
    case ObjectOp::kSampleCmpLevel: return HasShadowLevels(kind);
    case ObjectOp::kSampleCmpBias: return !is_cube_array && kind != ObjectKind::kTexture2DArray;
    default: return true;
  }
}

const Requirement* RequirementOf(Builtin builtin, const StageInfo& stage) {
  if (stage.emits_vertices || (builtin == Builtin::kPrimitiveId && stage.reads_vertices)) {
    if (const Requirement* requirement = Find(kBuiltinsOfEmission, builtin))
      return requirement->feature == Feature::kGeometryShaders ? nullptr : requirement;
  }
  // The number of the patch needs nothing but the stage.
  const bool is_of_patch = stage.reads_vertices && builtin == Builtin::kPrimitiveId;
  return is_of_patch ? nullptr : Find(kBuiltins, builtin);
}

const Requirement* RequirementOf(ObjectKind kind) {
  if (IsStorageBuffer(kind)) return &kStorageBuffer;
  return IsImage(kind) ? &kImage : Find(kObjects, kind);
}

const Requirement* RequirementOf(ObjectOp op) { return Find(kObjectOps, op); }

const Requirement* RequirementOf(Scalar kind) {
  switch (kind) {
    case Scalar::kDouble: return &kDouble;
    case Scalar::kInt64:
    case Scalar::kUint64: return &kInt64;
    default: return nullptr;
  }
}

}  // namespace clipc::glsl
