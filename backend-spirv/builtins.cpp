// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The inputs and outputs that mean something to the pipeline.
#include <algorithm>
#include <array>
#include <iterator>

#include "backend-spirv/writer.h"

namespace clipc::spirv {

using namespace ir;

namespace {

// A built-in variable of SPIR-V, and what a module needs that has it.
struct Row {
  Builtin builtin;
  spv::BuiltIn which;
  std::string_view name;         // GLSL's, which debuggers show
  Scalar scalar = Scalar::kInt;  // of an input
  spv::Capability capability = spv::Capability::Shader;
  std::string_view extension = {};
  std::uint32_t core = ~0u;  // the minor version of SPIR-V from which on it needs no extension
};

using Cap = spv::Capability;
using In = spv::BuiltIn;

constexpr std::string_view kDrawParameters = "SPV_KHR_shader_draw_parameters",
                           kShadingRate = "SPV_KHR_fragment_shading_rate",
                           kLayers = "SPV_EXT_shader_viewport_index_layer";

constexpr Row kInputs[] = {
    {Builtin::kVertexIndex, In::VertexIndex, "gl_VertexIndex"},
    {Builtin::kInstanceIndex, In::InstanceIndex, "gl_InstanceIndex"},
    {Builtin::kBaseVertex, In::BaseVertex, "gl_BaseVertex", Scalar::kInt, Cap::DrawParameters,
     kDrawParameters, 3},
    {Builtin::kBaseInstance, In::BaseInstance, "gl_BaseInstance", Scalar::kInt, Cap::DrawParameters,
     kDrawParameters, 3},
    {Builtin::kDrawIndex, In::DrawIndex, "gl_DrawID", Scalar::kInt, Cap::DrawParameters,
     kDrawParameters, 3},
    {Builtin::kViewId, In::ViewIndex, "gl_ViewIndex", Scalar::kInt, Cap::MultiView,
     "SPV_KHR_multiview", 3},
    {Builtin::kPixelPosition, In::FragCoord, "gl_FragCoord", Scalar::kFloat},
    {Builtin::kFrontFacing, In::FrontFacing, "gl_FrontFacing", Scalar::kBool},
    {Builtin::kSampleIndex, In::SampleId, "gl_SampleID", Scalar::kInt, Cap::SampleRateShading},
    {Builtin::kCoverageInput, In::SampleMask, "gl_SampleMaskIn"},
    {Builtin::kPrimitiveId, In::PrimitiveId, "gl_PrimitiveID", Scalar::kInt, Cap::Geometry},
    {Builtin::kLayerInput, In::Layer, "gl_Layer", Scalar::kInt, Cap::Geometry},
    {Builtin::kViewportInput, In::ViewportIndex, "gl_ViewportIndex", Scalar::kInt,
     Cap::MultiViewport},
    {Builtin::kBarycentrics, In::BaryCoordKHR, "gl_BaryCoordEXT", Scalar::kFloat,
     Cap::FragmentBarycentricKHR},
    {Builtin::kBarycentricsNoPerspective, In::BaryCoordNoPerspKHR, "gl_BaryCoordNoPerspEXT",
     Scalar::kFloat, Cap::FragmentBarycentricKHR},
    {Builtin::kFullyCovered, In::FullyCoveredEXT, "gl_FragFullyCoveredNV", Scalar::kBool,
     Cap::FragmentFullyCoveredEXT, "SPV_EXT_fragment_fully_covered"},
    {Builtin::kHelperLane, In::HelperInvocation, "gl_HelperInvocation", Scalar::kBool},
    {Builtin::kLaneCount, In::SubgroupSize, "gl_SubgroupSize", Scalar::kUint, Cap::GroupNonUniform},
    {Builtin::kLaneIndex, In::SubgroupLocalInvocationId, "gl_SubgroupInvocationID", Scalar::kUint,
     Cap::GroupNonUniform},
    {Builtin::kThreadId, In::GlobalInvocationId, "gl_GlobalInvocationID", Scalar::kUint},
    {Builtin::kGroupId, In::WorkgroupId, "gl_WorkGroupID", Scalar::kUint},
    {Builtin::kGroupThreadId, In::LocalInvocationId, "gl_LocalInvocationID", Scalar::kUint},
    {Builtin::kGroupIndex, In::LocalInvocationIndex, "gl_LocalInvocationIndex", Scalar::kUint},
    {Builtin::kPositionInput, In::Position, "gl_Position", Scalar::kFloat},
    {Builtin::kPointSizeInput, In::PointSize, "gl_PointSize", Scalar::kFloat},
    {Builtin::kEmitterId, In::InvocationId, "gl_InvocationID", Scalar::kInt, Cap::Geometry},
    {Builtin::kDomainLocation, In::TessCoord, "gl_TessCoord", Scalar::kFloat, Cap::Tessellation},
    {Builtin::kTessFactorInput, In::TessLevelOuter, "gl_TessLevelOuter", Scalar::kFloat,
     Cap::Tessellation},
    {Builtin::kInsideFactorInput, In::TessLevelInner, "gl_TessLevelInner", Scalar::kFloat,
     Cap::Tessellation},
    {Builtin::kControlPointId, In::InvocationId, "gl_InvocationID", Scalar::kInt,
     Cap::Tessellation},
    {Builtin::kShadingRateInput, In::ShadingRateKHR, "gl_ShadingRateEXT", Scalar::kInt,
     Cap::FragmentShadingRateKHR, kShadingRate},
    {Builtin::kClipDistanceInput, In::ClipDistance, "gl_ClipDistance", Scalar::kFloat,
     Cap::ClipDistance},
    {Builtin::kCullDistanceInput, In::CullDistance, "gl_CullDistance", Scalar::kFloat,
     Cap::CullDistance},
};

// Those that have another number for OpenGL.
constexpr Row kOpenGlInputs[] = {
    {Builtin::kVertexIndex, In::VertexId, "gl_VertexID"},
    {Builtin::kInstanceIndex, In::InstanceId, "gl_InstanceID"},
};

constexpr Row kOutputs[] = {
    {Builtin::kPosition, In::Position, "gl_Position"},
    {Builtin::kPointSize, In::PointSize, "gl_PointSize"},
    {Builtin::kClipDistance, In::ClipDistance, "gl_ClipDistance", Scalar::kFloat,
     Cap::ClipDistance},
    {Builtin::kCullDistance, In::CullDistance, "gl_CullDistance", Scalar::kFloat,
     Cap::CullDistance},
    {Builtin::kShadingRate, In::PrimitiveShadingRateKHR, "gl_PrimitiveShadingRateEXT", Scalar::kInt,
     Cap::FragmentShadingRateKHR, kShadingRate},
    {Builtin::kLayer, In::Layer, "gl_Layer", Scalar::kInt, Cap::ShaderViewportIndexLayerEXT,
     kLayers},
    {Builtin::kViewportIndex, In::ViewportIndex, "gl_ViewportIndex", Scalar::kInt,
     Cap::ShaderViewportIndexLayerEXT, kLayers},
    {Builtin::kPrimitiveIdOutput, In::PrimitiveId, "gl_PrimitiveID", Scalar::kInt, Cap::Geometry},
    {Builtin::kTessFactor, In::TessLevelOuter, "gl_TessLevelOuter", Scalar::kFloat,
     Cap::Tessellation},
    {Builtin::kInsideFactor, In::TessLevelInner, "gl_TessLevelInner", Scalar::kFloat,
     Cap::Tessellation},
    {Builtin::kDepth, In::FragDepth, "gl_FragDepth"},
    {Builtin::kDepthGreaterEqual, In::FragDepth, "gl_FragDepth"},
    {Builtin::kDepthLessEqual, In::FragDepth, "gl_FragDepth"},
    {Builtin::kCoverage, In::SampleMask, "gl_SampleMask"},
    {Builtin::kStencilRef, In::FragStencilRefEXT, "gl_FragStencilRefARB", Scalar::kInt,
     Cap::StencilExportEXT, "SPV_EXT_shader_stencil_export"},
};

const Row* RowOf(std::span<const Row> rows, Builtin builtin) {
  const auto found = std::ranges::find(rows, builtin, &Row::builtin);
  return found == rows.end() ? nullptr : &*found;
}

void Require(Module& module, const Row& row) {
  module.Require(row.capability);
  if (!row.extension.empty() && module.minor_version() < row.core) module.Require(row.extension);
}

}  // namespace

bool IsArrayInput(Builtin builtin) {
  return InfoOf(builtin).components == 0 && InfoOf(builtin).storage == Storage::kInput;
}

// SPIR-V has the factors of every domain in arrays of these sizes.
std::uint32_t FactorCount(Builtin builtin) {
  const bool is_inside =
      builtin == Builtin::kInsideFactorInput || builtin == Builtin::kInsideFactor;
  const bool is_edge = builtin == Builtin::kTessFactorInput || builtin == Builtin::kTessFactor;
  return is_inside ? 2 : is_edge ? 4 : 0;
}

Ref Writer::BuiltinVariable(spv::BuiltIn builtin, spv::StorageClass storage, Ref type,
                            std::string_view name) {
  Ref& variable = builtins_[{builtin, storage}];
  if (variable != 0) return variable;
  variable = module_.Variable(types_.Pointer(storage, type), storage);
  module_.Name(variable, name);
  module_.Decorate(variable, spv::Decoration::BuiltIn, {NumberOf(builtin)});
  shared_.push_back(variable);
  return variable;
}

// Declares the variable of a built-in input. `type` is that of its value.
Ref Writer::DeclareBuiltin(Builtin input, Ref type) {
  const Row* row = options_.is_opengl ? RowOf(kOpenGlInputs, input) : nullptr;
  if (!row) row = RowOf(kInputs, input);
  if (!row) return Lack("an input that no module has");
  if (row->capability == Cap::FragmentBarycentricKHR) RequireBarycentrics();
  // A stage of patches has the number of the patch without more.
  const StageInfo& stage = InfoOf(program_.stage);
  if (input != Builtin::kPrimitiveId || !stage.reads_vertices || stage.emits_vertices)
    Require(module_, *row);
  const bool is_new = !builtins_.contains({row->which, spv::StorageClass::Input});
  const Ref variable = BuiltinVariable(row->which, spv::StorageClass::Input, type, row->name);
  // Vulkan asks for it, as of every integer that a pixel shader reads.
  if (is_new && IsPixelShader() && IsInteger(row->scalar))
    module_.Decorate(variable, spv::Decoration::Flat);
  return variable;
}

// Loads a built-in input as SPIR-V has it.
Ref Writer::LoadBuiltin(Builtin input) {
  const Row* row = RowOf(kInputs, input);
  if (!row) return Lack("an input that no module has");
  const auto components = static_cast<std::uint32_t>(InfoOf(input).components);
  const Ref type = types_.Of(ShapeOf(row->scalar, 1, components));
  if (row->which != In::SampleMask)
    return Emit(spv::Op::OpLoad, type, {DeclareBuiltin(input, type)});
  // An array, of which the first 32 samples are all.
  const Ref array = module_.Type(spv::Op::OpTypeArray, {type, types_.Uint(1)});
  const Ref first = Emit(spv::Op::OpAccessChain, types_.Pointer(spv::StorageClass::Input, type),
                         {DeclareBuiltin(input, array), types_.Int(0)});
  return Emit(spv::Op::OpLoad, type, {first});
}

// Reads an input that the pipeline gives.
Ref Writer::ReadBuiltin(std::size_t number) {
  const IoVar& input = program_.inputs[number];
  const bool keeps_base = interface_.inputs[number].keeps_base;
  const Shape shape = ShapeOf(program_.types[(*this)[input.var].type]);
  const auto combined = [&](spv::Op op, Builtin index, Builtin base) {
    const Ref counted = LoadBuiltin(index);
    const Ref first = LoadBuiltin(base);
    return Emit(op, types_.Of(Scalar::kInt), {counted, first});
  };
  constexpr Builtin kVertex = Builtin::kVertexIndex, kInstance = Builtin::kInstanceIndex;
  Ref value = 0;
  switch (input.builtin) {
    case Builtin::kVertexId:
      value = keeps_base ? LoadBuiltin(kVertex)
                         : combined(spv::Op::OpISub, kVertex, Builtin::kBaseVertex);
      break;
    // OpenGL's number of an instance is without the first one's.
    case Builtin::kInstanceId:
      value = keeps_base || options_.is_opengl
                  ? LoadBuiltin(kInstance)
                  : combined(spv::Op::OpISub, kInstance, Builtin::kBaseInstance);
      break;
    case Builtin::kInstanceIndex:
      value = options_.is_opengl ? combined(spv::Op::OpIAdd, kInstance, Builtin::kBaseInstance)
                                 : LoadBuiltin(kInstance);
      break;
    default: value = LoadBuiltin(input.builtin); break;
  }
  NameInput(input);
  if (input.builtin == Builtin::kPixelPosition) {
    // SPIR-V has 1 / w where Direct3D has w.
    const Ref number = types_.Of(Scalar::kFloat);
    const Ref w = Emit(spv::Op::OpFDiv, number, {types_.Float(1), Part(number, value, 3)});
    return Emit(spv::Op::OpCompositeInsert, types_.Of(shape), {w, value, 3});
  }
  const Row* row = RowOf(kInputs, input.builtin);
  return Converted(value, ShapeOf(row ? row->scalar : Scalar::kInt, 1, shape.size), shape.scalar);
}

// Names the semantic of the variable that was read for the input.
void Writer::NameInput(const IoVar& input) {
  const Builtin first = input.builtin == Builtin::kVertexId     ? Builtin::kVertexIndex
                        : input.builtin == Builtin::kInstanceId ? Builtin::kInstanceIndex
                                                                : input.builtin;
  const Row* row = RowOf(kInputs, first);
  if (row) NameSemantic(builtins_[{row->which, spv::StorageClass::Input}], input);
}

// Declares an output that is built in; returns whether it is one.
bool Writer::DeclareBuiltinOutput(const IoVar& output, std::string_view name) {
  if (output.builtin == Builtin::kNone) return false;
  const Row* row = RowOf(kOutputs, output.builtin);
  if (!row) {
    Lack("an output that no module has");
    return true;
  }
  Row needed = *row;
  if (row->extension == kLayers && InfoOf(program_.stage).emits_vertices) {
    needed.capability = row->which == In::Layer ? Cap::Geometry : Cap::MultiViewport;
    needed.extension = {};
  } else if (row->extension == kLayers && module_.minor_version() >= 5) {
    needed.capability = row->which == In::Layer ? Cap::ShaderLayer : Cap::ShaderViewportIndex;
    needed.extension = {};
  }
  Require(module_, needed);
  const bool is_outer = row->which == In::TessLevelOuter;
  const bool is_factor = is_outer || row->which == In::TessLevelInner;
  // SPIR-V has so many factors whatever the domain is.
  Ref type = is_factor ? module_.Type(spv::Op::OpTypeArray,
                                      {types_.Of(Scalar::kFloat), types_.Uint(is_outer ? 4 : 2)})
                       : types_.Of((*this)[output.var].type);
  if (row->which == In::SampleMask) {
    type = module_.Type(spv::Op::OpTypeArray, {type, types_.Uint(1)});
    part_indices_[output.var.index] = {types_.Int(0)};
    name = row->name;
  }
  if (IsOfPoint(output)) {
    type = OfPoints(type);
    part_indices_[output.var.index] = {types_.Int(0)};
  }
  const Ref variable = BuiltinVariable(row->which, spv::StorageClass::Output, type, name);
  if (is_factor) module_.Decorate(variable, spv::Decoration::Patch);
  NameSemantic(variable, output);
  pointers_[output.var.index] = variable;
  if (output.builtin == Builtin::kPosition && options_.invariant)
    module_.Decorate(variable, spv::Decoration::Invariant);
  if (row->which == In::FragDepth) module_.Execution(spv::ExecutionMode::DepthReplacing);
  if (output.builtin == Builtin::kDepthGreaterEqual)
    module_.Execution(spv::ExecutionMode::DepthGreater);
  if (output.builtin == Builtin::kDepthLessEqual) module_.Execution(spv::ExecutionMode::DepthLess);
  if (output.builtin == Builtin::kStencilRef)
    module_.Execution(spv::ExecutionMode::StencilRefReplacingEXT);
  return true;
}

}  // namespace clipc::spirv
