// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// What the shader shares with the pipeline: inputs, outputs, constant buffers and global variables.
#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "backend-spirv/block_fit.h"
#include "backend-spirv/writer.h"
#include "ir/evaluate.h"

namespace clipc::spirv {

using namespace ir;

namespace {

bool IsFlat(Scalar scalar) { return !IsFloat(scalar) || BaseOf(scalar) == Scalar::kDouble; }

}  // namespace

void Writer::Interpolate(Ref variable, const IoVar& io) {
  const Scalar scalar = program_.types[(*this)[io.var].type].scalar;
  const bool is_flat = IsFlat(scalar) || io.interpolation == Interpolation::kNoInterpolation;
  if (is_flat)
    module_.Decorate(variable, spv::Decoration::Flat);
  else if (io.interpolation == Interpolation::kNoPerspective)
    module_.Decorate(variable, spv::Decoration::NoPerspective);
  if (io.centroid) module_.Decorate(variable, spv::Decoration::Centroid);
  if (io.sample) {
    module_.Require(spv::Capability::SampleRateShading);
    module_.Decorate(variable, spv::Decoration::Sample);
  }
}

Ref Writer::BuiltinVariable(spv::BuiltIn builtin, spv::StorageClass storage, Ref type,
                            std::string_view name) {
  Ref& variable = builtins_[{builtin, storage}];
  if (variable != 0) return variable;
  variable = module_.Variable(types_.Pointer(storage, type), storage);
  module_.Name(variable, name);
  module_.Decorate(variable, spv::Decoration::BuiltIn, {NumberOf(builtin)});
  const bool is_integer = IsPixelShader() && storage == spv::StorageClass::Input &&
                          builtin != spv::BuiltIn::FragCoord &&
                          builtin != spv::BuiltIn::FrontFacing;
  if (is_integer) module_.Decorate(variable, spv::Decoration::Flat);
  shared_.push_back(variable);
  return variable;
}

void Writer::DeclareInputs() {
  for (std::size_t i = 0; i < program_.inputs.size(); ++i) {
    const IoVar& input = program_.inputs[i];
    if (input.builtin != Builtin::kNone)
      builtin_inputs_.emplace(input.var.index, &input);
    else if (is_read_[input.var.index])
      DeclareInput(input, interface_.inputs[i]);
  }
}

void Writer::DeclareInput(const IoVar& input, const Interface::Variable& place) {
  if (!place.location || (input.reader && !input.reader->IsWhole())) {
    Lack("an input that is a part of another stage's");
    return;
  }
  constexpr auto kStorage = spv::StorageClass::Input;
  const Ref type = types_.Of((*this)[input.var].type);
  const Ref variable = module_.Variable(types_.Pointer(kStorage, type), kStorage);
  module_.Name(variable, place.name);
  module_.Decorate(variable, spv::Decoration::Location, {*place.location});
  if (IsPixelShader()) Interpolate(variable, input);
  shared_.push_back(variable);
  pointers_[input.var.index] = variable;
  storages_[input.var.index] = kStorage;
}

// Drivers write the outputs in the order of their declarations. It costs least if that is the order
// in which the shader writes them, and the position is the last.
std::vector<std::size_t> Writer::OrderOfOutputs() const {
  std::vector<std::size_t> order(program_.outputs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t output) {
    const IoVar& io = program_.outputs[output];
    const auto mention = std::ranges::find(mentioned_outputs_, io.var);
    return std::pair(io.builtin != Builtin::kNone, mention - mentioned_outputs_.begin());
  });
  return order;
}

void Writer::DeclareOutputs() {
  for (const std::size_t i : OrderOfOutputs())
    DeclareOutput(program_.outputs[i], interface_.outputs[i]);
}

void Writer::DeclareOutput(const IoVar& output, const Interface::Variable& place) {
  constexpr auto kStorage = spv::StorageClass::Output;
  const Var& var = (*this)[output.var];
  const Ref type = types_.Of(var.type);
  storages_[output.var.index] = kStorage;
  Ref& variable = pointers_[output.var.index];
  const auto builtin = [&](spv::BuiltIn which) {
    variable = BuiltinVariable(which, kStorage, type, place.name);
  };
  switch (output.builtin) {
    case Builtin::kNone: break;
    case Builtin::kPosition:
      builtin(spv::BuiltIn::Position);
      if (options_.invariant) module_.Decorate(variable, spv::Decoration::Invariant);
      return;
    case Builtin::kPointSize: return builtin(spv::BuiltIn::PointSize);
    case Builtin::kClipDistance:
      module_.Require(spv::Capability::ClipDistance);
      return builtin(spv::BuiltIn::ClipDistance);
    case Builtin::kCullDistance:
      module_.Require(spv::Capability::CullDistance);
      return builtin(spv::BuiltIn::CullDistance);
    case Builtin::kDepth:
    case Builtin::kDepthGreaterEqual:
    case Builtin::kDepthLessEqual:
      module_.Execution(spv::ExecutionMode::DepthReplacing);
      if (output.builtin == Builtin::kDepthGreaterEqual)
        module_.Execution(spv::ExecutionMode::DepthGreater);
      if (output.builtin == Builtin::kDepthLessEqual)
        module_.Execution(spv::ExecutionMode::DepthLess);
      return builtin(spv::BuiltIn::FragDepth);
    default: Lack("an output that few shaders have"); return;
  }
  if (!place.location || (output.reader && (!output.reader->IsWhole() || output.reader->group))) {
    Lack("an output that is a part of another stage's");
    return;
  }
  variable = module_.Variable(types_.Pointer(kStorage, type), kStorage);
  module_.Name(variable, place.name);
  module_.Decorate(variable, spv::Decoration::Location, {*place.location});
  if (output.blend_index > 0)
    module_.Decorate(variable, spv::Decoration::Index, {output.blend_index});
  if (!IsPixelShader()) Interpolate(variable, output);
  shared_.push_back(variable);
}

// Reads an input that the pipeline gives.
Ref Writer::ReadInput(VarId id) {
  const IoVar& input = *builtin_inputs_.at(id.index);
  return ReadBuiltin(input);
}

Ref Writer::ReadBuiltin(const IoVar& input) {
  constexpr auto kInput = spv::StorageClass::Input;
  const Shape shape = ShapeOf(program_.types[(*this)[input.var].type]);
  const auto read = [&](spv::BuiltIn which, Ref type, std::string_view name) {
    return Emit(spv::Op::OpLoad, type, {BuiltinVariable(which, kInput, type, name)});
  };
  const auto integer = [&](spv::BuiltIn which, std::string_view name) {
    return read(which, types_.Of(Scalar::kInt), name);
  };
  const auto converted = [&](Ref number) {
    return Converted(number, {Shape::kScalar, Scalar::kInt, 1, 1}, shape.scalar);
  };
  const auto difference = [&](Ref a, Ref b) {
    return converted(Emit(spv::Op::OpISub, types_.Of(Scalar::kInt), {a, b}));
  };
  const auto draw_parameter = [&](spv::BuiltIn which, std::string_view name) {
    module_.Require(spv::Capability::DrawParameters);
    if (module_.minor_version() < 3) module_.Require("SPV_KHR_shader_draw_parameters");
    return integer(which, name);
  };
  switch (input.builtin) {
    case Builtin::kVertexIndex:
      return converted(integer(spv::BuiltIn::VertexIndex, "gl_VertexIndex"));
    case Builtin::kInstanceIndex:
      return converted(integer(spv::BuiltIn::InstanceIndex, "gl_InstanceIndex"));
    case Builtin::kVertexId: {
      const Ref index = integer(spv::BuiltIn::VertexIndex, "gl_VertexIndex");
      if (options_.base_vertex_is_zero) return converted(index);
      const Ref base = draw_parameter(spv::BuiltIn::BaseVertex, "gl_BaseVertex");
      return difference(index, base);
    }
    case Builtin::kInstanceId: {
      const Ref index = integer(spv::BuiltIn::InstanceIndex, "gl_InstanceIndex");
      if (options_.base_instance_is_zero) return converted(index);
      const Ref base = draw_parameter(spv::BuiltIn::BaseInstance, "gl_BaseInstance");
      return difference(index, base);
    }
    case Builtin::kBaseVertex:
      return converted(draw_parameter(spv::BuiltIn::BaseVertex, "gl_BaseVertex"));
    case Builtin::kBaseInstance:
      return converted(draw_parameter(spv::BuiltIn::BaseInstance, "gl_BaseInstance"));
    case Builtin::kDrawIndex:
      return converted(draw_parameter(spv::BuiltIn::DrawIndex, "gl_DrawID"));
    case Builtin::kFrontFacing:
      return read(spv::BuiltIn::FrontFacing, types_.Of(Scalar::kBool), "gl_FrontFacing");
    case Builtin::kSampleIndex:
      module_.Require(spv::Capability::SampleRateShading);
      return converted(integer(spv::BuiltIn::SampleId, "gl_SampleID"));
    case Builtin::kPrimitiveId:
      module_.Require(spv::Capability::Geometry);
      return converted(integer(spv::BuiltIn::PrimitiveId, "gl_PrimitiveID"));
    case Builtin::kPixelPosition: {
      // SPIR-V has 1 / w where Direct3D has w.
      const Ref place = read(spv::BuiltIn::FragCoord, types_.Of(shape), "gl_FragCoord");
      const Ref number = types_.Of(Scalar::kFloat);
      const Ref w = Emit(spv::Op::OpFDiv, number, {types_.Float(1), Part(number, place, 3)});
      return Emit(spv::Op::OpCompositeInsert, types_.Of(shape), {w, place, 3});
    }
    default: return Lack("an input that few shaders have");
  }
}

// Runs before the statements of `main`: gives the static variables their first values, and the
// depth that of the primitive, which a path that does not write it has.
void Writer::StartMain() {
  for (const VarId id : late_) Store(PlaceOfVariable(id), Value((*this)[id].init));
  for (const IoVar& output : program_.outputs) {
    const bool is_depth = output.builtin == Builtin::kDepth ||
                          output.builtin == Builtin::kDepthGreaterEqual ||
                          output.builtin == Builtin::kDepthLessEqual;
    if (!is_depth || !output.may_be_unwritten || output.is_unwritten) continue;
    const Ref four = types_.Of(ShapeOf(Scalar::kFloat, 1, 4));
    const Ref place = Emit(
        spv::Op::OpLoad, four,
        {BuiltinVariable(spv::BuiltIn::FragCoord, spv::StorageClass::Input, four, "gl_FragCoord")});
    Store(PlaceOfVariable(output.var), Part(types_.Of(Scalar::kFloat), place, 2));
  }
}

void Writer::DeclareGlobals() {
  for (const VarId id : program_.globals) {
    if (is_read_[id.index]) DeclareStatic(id);
  }
}

// A constant that the application may give another value when it makes a pipeline.
Ref Writer::Specialised(VarId id, std::span<const std::uint64_t> bits) {
  const Var& var = (*this)[id];
  const Type& type = program_.types[var.type];
  const Ref of = types_.Of(var.type);
  Ref made = 0;
  if (BaseOf(type.scalar) == Scalar::kBool) {
    made = module_.OwnConstant(
        bits[0] != 0 ? spv::Op::OpSpecConstantTrue : spv::Op::OpSpecConstantFalse, of, {});
  } else if (IsWide(type.scalar)) {
    return Lack("a constant of 64 bits");
  } else {
    made = module_.OwnConstant(spv::Op::OpSpecConstant, of, {static_cast<std::uint32_t>(bits[0])});
  }
  module_.Name(made, var.name);
  module_.Decorate(made, spv::Decoration::SpecId, {*var.constant_id});
  return made;
}

void Writer::DeclareStatic(VarId id) {
  const Var& var = (*this)[id];
  const auto bits =
      var.init ? ConstantBits(program_, var.init) : std::optional<std::vector<std::uint64_t>>();
  if (var.constant_id) {
    const std::uint64_t zero[] = {0};
    values_[id.index] = Specialised(id, bits ? std::span<const std::uint64_t>(*bits) : zero);
    return;
  }
  const bool is_constant = !var.init || bits;
  Ref initial = 0;
  if (bits) {
    std::span<const std::uint64_t> left(*bits);
    initial = types_.Value(var.type, left);
  } else if (!var.init) {
    initial = types_.Zero(var.type);
  }
  if (is_constant && !in_memory_[id.index]) {
    values_[id.index] = initial;
    return;
  }
  constexpr auto kStorage = spv::StorageClass::Private;
  const Ref variable =
      module_.Variable(types_.Pointer(kStorage, types_.Of(var.type)), kStorage, initial);
  module_.Name(variable, var.name);
  if (module_.minor_version() >= 4) shared_.push_back(variable);
  pointers_[id.index] = variable;
  storages_[id.index] = kStorage;
  if (!is_constant) late_.push_back(id);
}

Ref Writer::BlockVariable(CbufferId id) {
  const auto found = blocks_.find(id.index);
  if (found != blocks_.end()) return found->second.variable;
  DeclaredBlock& declared = blocks_[id.index];
  const Cbuffer& cbuffer = program_.cbuffers[id];
  const auto place = std::ranges::find(interface_.blocks, id, &Interface::Block::cbuffer);
  auto kept = FittingMembers(program_, cbuffer, is_read_, module_.minor_version() >= 3);
  if (!kept || place == interface_.blocks.end())
    return Lack("a constant buffer that no block has at its places");
  declared.kept = std::move(*kept);
  const auto storage =
      cbuffer.is_push_constant ? spv::StorageClass::PushConstant : spv::StorageClass::Uniform;
  Ref type = types_.Block(cbuffer, declared.kept, place->name);
  const bool is_constant_buffer = cbuffer.kind == CbufferKind::kConstantBuffer;
  std::vector<std::uint32_t> counts;
  for (const Type* of = &program_.types[(*this)[cbuffer.members[0].var].type];
       is_constant_buffer && of->kind == TypeKind::kArray; of = &program_.types[of->element])
    counts.insert(counts.begin(), of->count);
  for (const std::uint32_t count : counts)
    type = module_.Type(spv::Op::OpTypeArray, {type, types_.Uint(count)});
  if (!counts.empty()) return Lack("an array of constant buffers");
  declared.variable = module_.Variable(types_.Pointer(storage, type), storage);
  module_.Name(declared.variable,
               is_constant_buffer ? (*this)[cbuffer.members[0].var].name : cbuffer.name);
  if (!cbuffer.is_push_constant) {
    module_.Decorate(declared.variable, spv::Decoration::DescriptorSet, {place->set});
    module_.Decorate(declared.variable, spv::Decoration::Binding, {place->binding});
  }
  if (module_.minor_version() >= 4) shared_.push_back(declared.variable);
  return declared.variable;
}

}  // namespace clipc::spirv
