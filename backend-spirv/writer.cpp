// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-spirv/writer.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace clipc::spirv {

using namespace ir;

namespace {

// By stage.
constexpr spv::ExecutionModel kModels[] = {spv::ExecutionModel::Vertex,
                                           spv::ExecutionModel::Fragment,
                                           spv::ExecutionModel::GLCompute,
                                           spv::ExecutionModel::Geometry,
                                           spv::ExecutionModel::TessellationControl,
                                           spv::ExecutionModel::TessellationEvaluation};
static_assert(std::size(kModels) == kStageCount);

// The primitives that a stage takes and gives. By Primitive.
constexpr spv::ExecutionMode kPrimitivesIn[] = {
    spv::ExecutionMode::InputPoints, spv::ExecutionMode::InputLines, spv::ExecutionMode::Triangles,
    spv::ExecutionMode::InputLinesAdjacency, spv::ExecutionMode::InputTrianglesAdjacency};
static_assert(std::size(kPrimitivesIn) == std::size(kPrimitives));
constexpr spv::ExecutionMode kPrimitivesOut[] = {spv::ExecutionMode::OutputPoints,
                                                 spv::ExecutionMode::OutputLineStrip,
                                                 spv::ExecutionMode::OutputTriangleStrip};

void AddEmission(Module& module, const Emission& emission) {
  module.Require(spv::Capability::Geometry);
  module.Execution(kPrimitivesIn[static_cast<std::size_t>(emission.input)]);
  module.Execution(spv::ExecutionMode::Invocations, {emission.instances});
  module.Execution(kPrimitivesOut[static_cast<std::size_t>(emission.output)]);
  module.Execution(spv::ExecutionMode::OutputVertices, {emission.max_vertices});
}

// How a domain shader's patches are cut and joined; backend-glsl/writer/stage_writer.cpp has why
// the winding of OpenGL is the other one.
void AddTessellation(Module& module, const Tessellation& patch, bool is_opengl) {
  constexpr spv::ExecutionMode kShapes[] = {
      spv::ExecutionMode::Triangles, spv::ExecutionMode::Quads, spv::ExecutionMode::Isolines};
  constexpr spv::ExecutionMode kSpacings[] = {
      spv::ExecutionMode::SpacingEqual, spv::ExecutionMode::SpacingEqual,
      spv::ExecutionMode::SpacingFractionalEven, spv::ExecutionMode::SpacingFractionalOdd};
  module.Require(spv::Capability::Tessellation);
  module.Execution(kShapes[static_cast<std::size_t>(*patch.domain)]);
  module.Execution(
      kSpacings[static_cast<std::size_t>(patch.partitioning.value_or(Partitioning::kInteger))]);
  const bool is_clockwise =
      patch.topology.value_or(OutputTopology::kTriangleCw) == OutputTopology::kTriangleCw;
  module.Execution(is_clockwise == !is_opengl ? spv::ExecutionMode::VertexOrderCw
                                              : spv::ExecutionMode::VertexOrderCcw);
  if (patch.topology == OutputTopology::kPoint) module.Execution(spv::ExecutionMode::PointMode);
}

// A domain shader of another tool may have nothing of these but the domain. OpenGL links what each
// shader says, and has it of the domain shader.
constexpr spv::ExecutionMode kDomainModes[] = {
    spv::ExecutionMode::Triangles, spv::ExecutionMode::Quads, spv::ExecutionMode::Isolines};
static_assert(std::size(kDomainModes) == std::size(kDomains));

void AddPatches(Module& module, const Tessellation& patches, bool is_opengl) {
  module.Require(spv::Capability::Tessellation);
  module.Execution(spv::ExecutionMode::OutputVertices, {patches.output_points});
  if (is_opengl) return;
  module.Execution(kDomainModes[static_cast<std::size_t>(*patches.domain)]);
  switch (*patches.partitioning) {
    case Partitioning::kFractionalEven:
      module.Execution(spv::ExecutionMode::SpacingFractionalEven);
      break;
    case Partitioning::kFractionalOdd:
      module.Execution(spv::ExecutionMode::SpacingFractionalOdd);
      break;
    default: module.Execution(spv::ExecutionMode::SpacingEqual); break;
  }
  switch (*patches.topology) {
    case OutputTopology::kPoint: module.Execution(spv::ExecutionMode::PointMode); break;
    case OutputTopology::kTriangleCw: module.Execution(spv::ExecutionMode::VertexOrderCw); break;
    case OutputTopology::kTriangleCcw: module.Execution(spv::ExecutionMode::VertexOrderCcw); break;
    default: break;
  }
}

// The invocations of a pixel, or of a sample, come one after the other.
void RequireOrder(Module& module, const Program& program) {
  const bool is_per_sample = std::ranges::any_of(program.inputs, [](const IoVar& input) {
    return input.sample || input.builtin == Builtin::kSampleIndex;
  });
  module.Require("SPV_EXT_fragment_shader_interlock");
  module.Require(is_per_sample ? spv::Capability::FragmentShaderSampleInterlockEXT
                               : spv::Capability::FragmentShaderPixelInterlockEXT);
  module.Execution(is_per_sample ? spv::ExecutionMode::SampleInterlockOrderedEXT
                                 : spv::ExecutionMode::PixelInterlockOrderedEXT);
}

}  // namespace

Writer::Writer(const Program& program, const Interface& interface, const Options& options)
    : Emitter(program, options),
      interface_(interface),
      values_(program.vars.size()),
      pointers_(program.vars.size()),
      storages_(program.vars.size(), spv::StorageClass::Function),
      in_memory_(program.vars.size()),
      is_read_(program.vars.size()),
      is_precise_var_(program.vars.size()) {}

Written Writer::Run() {
  functions_.push_back(program_.main);
  for (std::size_t i = 0; i < functions_.size(); ++i) FindMemory(functions_[i]);
  if (options_.keeps_bindings) {
    for (const CbufferId id : program_.cbuffers.ids())
      for (const CbufferMember& member : program_.cbuffers[id].members)
        is_read_[member.var.index] = true;
  }
  FindPrecise();
  has_order_ = std::ranges::any_of(program_.resources, [&](const Resource& resource) {
    const TypeId type = program_.types.Innermost((*this)[resource.var].type);
    return is_read_[resource.var.index] && IsOrdered(program_.types[type].object);
  });
  lines_.Start();
  DeclareInputs();
  DeclareOutputs();
  DeclareGlobals();
  for (const FunctionId function : functions_) {
    if (lacks_.empty()) WriteFunction(function);
  }
  if (options_.keeps_bindings) DeclareUnread();
  if (!lacks_.empty()) return {{}, lacks_};
  const StageInfo& stage = InfoOf(program_.stage);
  // An image of OpenGL that is upside down has its own origin.
  const bool is_turned = options_.is_opengl && options_.has_upper_left_origin;
  if (stage.draws_pixels)
    module_.Execution(is_turned ? spv::ExecutionMode::OriginLowerLeft
                                : spv::ExecutionMode::OriginUpperLeft);
  if (stage.runs_in_groups) {
    const auto& [x, y, z] = program_.group_size;
    module_.Execution(spv::ExecutionMode::LocalSize, {x, y, z});
    SpecialiseGroup();
  }
  if (stage.emits_vertices) AddEmission(module_, program_.emission);
  if (stage.makes_patches) AddPatches(module_, program_.tessellation, options_.is_opengl);
  if (stage.reads_patches) AddTessellation(module_, program_.tessellation, options_.is_opengl);
  if (has_order_) RequireOrder(module_, program_);
  if (program_.tests_early) module_.Execution(spv::ExecutionMode::EarlyFragmentTests);
  const auto version =
      static_cast<std::uint32_t>(program_.profile.major * 100 + program_.profile.minor * 10);
  return {module_.Finish(kModels[static_cast<std::size_t>(program_.stage)],
                         FunctionRef(program_.main), options_.entry, shared_, version),
          {}};
}

// Makes the size of a group of the constants that the application may give other values.
void Writer::SpecialiseGroup() {
  const auto& constants = program_.group_size_constants;
  if (options_.is_opengl || std::ranges::none_of(constants, [](VarId id) { return bool{id}; }))
    return;
  const Ref number = types_.Of(Scalar::kUint);
  Ref sizes[3];
  for (std::size_t i = 0; i < constants.size(); ++i) {
    const std::uint32_t size = program_.group_size[i];
    sizes[i] = types_.Uint(size);
    if (!constants[i]) continue;
    sizes[i] = module_.OwnConstant(spv::Op::OpSpecConstant, number, {size});
    module_.Decorate(sizes[i], spv::Decoration::SpecId, {*(*this)[constants[i]].constant_id});
  }
  const Ref all = module_.OwnConstant(spv::Op::OpSpecConstantComposite, types_.Vector(number, 3),
                                      {sizes[0], sizes[1], sizes[2]});
  module_.Decorate(all, spv::Decoration::BuiltIn, {NumberOf(spv::BuiltIn::WorkgroupSize)});
}

Written Write(const Program& program, const Interface& interface, const Options& options) {
  return Writer(program, interface, options).Run();
}

}  // namespace clipc::spirv
